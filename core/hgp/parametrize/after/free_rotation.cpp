#include "hgp/parametrize/after/free_rotation.h"

#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// A sum of directions below this share of its weights decides nothing.
constexpr double kDecided = 1e-3;

Complex power(const Complex& unit, int q) {
  Complex result = 1.0;
  for (int i = 0; i < q; ++i) result *= unit;
  return result;
}

/// Σ w e^{iqφ} and Σ w.
struct Directions {
  Complex sum = 0.0;
  double weights = 0.0;
  void add(const Complex& direction, double weight, int q) {
    const double length = portable::abs(direction);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(weight)) return;
    sum += weight * power(direction / length, q);
    weights += weight;
  }
  bool isDecided() const { return portable::abs(sum) > kDecided * weights; }
};

class FreeRotation {
 public:
  FreeRotation(const TriMesh& mesh, const CutMesh& cut, int q, const std::vector<Complex>& z)
      : mesh_(mesh), cut_(cut), q_(q), z_(z) {}

  double angle() const {
    Directions directions;
    if (q_ % 2 == 0) directions = ofEdges();
    if (!directions.isDecided()) directions = ofAxes();
    return directions.isDecided() ? -portable::arg(directions.sum) / q_ : 0.0;
  }

 private:
  Complex at(HalfedgeId h) const { return z_[static_cast<std::size_t>(cut_.copy[h].i)]; }
  Vec3 vector(HalfedgeId h) const {
    return subtract(mesh_.position(mesh_.head(h)), mesh_.position(mesh_.tail(h)));
  }
  /// Twice the area times the normal.
  Vec3 normal(FaceId f) const {
    return cross(vector(TriMesh::halfedge(f, 0)), vector(TriMesh::halfedge(f, 1)));
  }

  double bend(HalfedgeId h) const {
    if (mesh_.isBoundary(h)) return 0.5 * kPi;
    const Vec3 a = normal(TriMesh::face(h)), b = normal(TriMesh::face(mesh_.twin(h)));
    return portable::atan2(norm(cross(a, b)), dot(a, b));
  }

  Directions ofEdges() const {
    Directions directions;
    for (EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      const double beta = bend(h);
      directions.add(at(TriMesh::next(h)) - at(h), norm(vector(h)) * beta * beta, q_);
    }
    return directions;
  }

  /// An axis a projects onto a face as the gradient of a·p, whose image under the linear map of the face is J ∇(a·p).
  Directions ofAxes() const {
    Directions directions;
    for (int axis = 0; axis < 3 && !directions.isDecided(); ++axis) {
      directions = {};
      for (FaceId f : mesh_.faces()) {
        const HalfedgeId h = TriMesh::halfedge(f, 0);
        const Vec3 n = normal(f), e1 = vector(h), e2 = scaled(vector(TriMesh::previous(h)), -1.0);
        const double square = dot(n, n);
        if (!(square > 0.0)) continue;
        Vec3 a{0, 0, 0};
        a[static_cast<std::size_t>(axis)] = 1.0;
        // The projection is s e1 + t e2.
        const double s = dot(cross(a, e2), n) / square, t = dot(cross(e1, a), n) / square;
        const Complex z0 = at(h), z1 = at(TriMesh::next(h)), z2 = at(TriMesh::previous(h));
        const Vec3 along = add(scaled(e1, s), scaled(e2, t));
        directions.add(s * (z1 - z0) + t * (z2 - z0), 0.5 * std::sqrt(square) * norm(along), q_);
      }
    }
    return directions;
  }

  const TriMesh& mesh_;
  const CutMesh& cut_;
  const int q_;
  const std::vector<Complex>& z_;
};

std::vector<Complex> copiesOf(const Solution& solution) {
  const Eigen::VectorXcd copies = solution.setup->unknowns.copies * solution.x;
  return {copies.data(), copies.data() + copies.size()};
}

bool isThere(const Solution& solution) { return solution.x.size() > 0 && solution.x.allFinite(); }

void turn(const TriMesh& mesh, double angle, MappedSolution& mapped) {
  if (angle == 0.0) return;
  MappedSolution turned = mapped;
  turned.solution.x *= portable::polar(1.0, angle);
  for (double& frame : turned.solution.frames.angles) frame -= angle;
  turned.map = layOut(mesh, turned.solution);
  turned.certificate = certify(mesh, toSpec(turned.solution.setup->field.spec), turned.map);
  if (mapped.certificate.isCertified && !turned.certificate.isCertified) return;
  mapped = std::move(turned);
}

}  // namespace

double freeRotation(const TriMesh& mesh, const CutMesh& cut, int q, const std::vector<Complex>& z) {
  return FreeRotation(mesh, cut, q, z).angle();
}

void turnAsTheSurfaceLies(const TriMesh& mesh, MappedSolution& mapped) {
  if (!isThere(mapped.solution)) return;
  const SeamlessSetup& setup = *mapped.solution.setup;
  turn(mesh, freeRotation(mesh, setup.cut, setup.seams.q, copiesOf(mapped.solution)), mapped);
}

void turnAsFramesSay(const TriMesh& mesh, MappedSolution& mapped) {
  if (!isThere(mapped.solution)) return;
  const SeamlessSetup& setup = *mapped.solution.setup;
  const std::vector<Complex> z = copiesOf(mapped.solution);
  Directions directions;
  for (FaceId f : mesh.faces()) {
    const LinearParts parts = linearParts(setup.context->geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k)
      similarity += parts.similarity[static_cast<std::size_t>(k)] *
                    z[static_cast<std::size_t>(setup.cut.copy[TriMesh::halfedge(f, k)].i)];
    directions.add(similarity * portable::polar(1.0, setup.seams.frameAngle[f]),
                   setup.context->geometry.area[f], 1);
  }
  if (directions.isDecided()) turn(mesh, -portable::arg(directions.sum), mapped);
}

}  // namespace hgp
