#include "hgp/field/smooth_field.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"
#include "hgp/field/field_system.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/mesh/defects.h"
#include "hgp/mesh/surface_order.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

/// Number of inverse iterations; more are not needed, because the field only serves to choose cones.
constexpr int kInverseIterations = 2;
/// Largest number of faces or patches that is solved directly, and the number of sweeps on every finer level. Values
/// from 5000 to 30 000 and from 2 to 10 lead to equally good cones.
constexpr int kDirectSize = 5000;
constexpr int kSweeps = 6;
/// Coarsening ends if pairing leaves more than this fraction of the unknowns, as on stars with many arms.
constexpr double kMinShrinking = 0.9;
/// Shift relative to the mean diagonal, so that the matrix can be factored even if there is an exactly parallel field.
constexpr double kShift = 1e-8;
/// Weight of a held direction: beside it, no dual edge matters.
constexpr double kHeldWeight = 1e3;

/// Centroids lie at a third of the heights, so that those of two triangles with areas A + B over an edge of length l
/// are 2(A + B)/(3l) apart across it.
constexpr double kLengthOverDistance = 1.5;
/// Bounds of a dual edge's weight, which is √3 between equilateral triangles: a sliver neither decides alone nor comes
/// loose.
constexpr double kMinDualWeight = 0.05, kMaxDualWeight = 20.0;
/// Triangles that a thread takes at a time.
constexpr int kFacesAtOnce = 512;
constexpr double kMinAreas = 1e-12;  ///< in units of the mean edge length squared: no division by 0
/// π(3 − √5): multiples of the golden angle are spread evenly and never repeat.
constexpr double kGoldenAngle = 2.399963229728653;
/// |κ₁ − κ₂| times the mean edge length: from 1 on a principal direction counts fully, and below 10⁻³ it is rounding
/// of the normals or of a sphere's vertices.
constexpr double kFullBending = 1.0, kMinBending = 1e-3;

/// Edge length over the distance of the face centres, clamped: the dual edge's weight.
double dualWeight(const Geometry& geometry, HalfedgeId h, double areas) {
  const double length = geometry.length[h];
  return std::clamp(kLengthOverDistance * length * length / std::max(areas, kMinAreas),
                    kMinDualWeight, kMaxDualWeight);
}

struct AlignedTerm {
  FaceId face;
  double weight;
  Complex direction;  ///< e^{iqφ}
};

std::vector<AlignedTerm> boundaryTerms(const TriMesh& mesh, const Geometry& geometry, int q) {
  std::vector<AlignedTerm> terms;
  for (HalfedgeId h : mesh.halfedges()) {
    if (!mesh.isBoundary(h)) continue;
    const FaceId f = TriMesh::face(h);
    terms.push_back({f, 2.0 * dualWeight(geometry, h, geometry.area[f]),
                     portable::polar(1.0, q * geometry.direction[h])});
  }
  return terms;
}

/// What an unknown stands for: in the order of the surface, relative to the halfedge of the face in that order. The numbers
/// of a file change rounding at most, which has to be far from deciding which faces are paired or where fields start.
struct Unknowns {
  std::vector<HalfedgeId> halfedge;  ///< of unknown i
  PerFace<int> of;                   ///< face → unknown
  PerFace<Complex> turn;             ///< e^{iqφ} of that halfedge's direction φ
};

Unknowns unknownsOf(const TriMesh& mesh, const Geometry& geometry, int q) {
  const auto n = static_cast<std::size_t>(mesh.faceCount());
  Unknowns unknowns{surfaceOrder(mesh), PerFace<int>(n), PerFace<Complex>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const HalfedgeId h = unknowns.halfedge[i];
    unknowns.of[TriMesh::face(h)] = static_cast<int>(i);
    unknowns.turn[TriMesh::face(h)] = portable::polar(1.0, q * geometry.direction[h]);
  }
  return unknowns;
}

FieldSystem fieldSystem(const TriMesh& mesh, const Geometry& geometry, int q,
                        const Unknowns& unknowns, const std::vector<AlignedTerm>& aligned) {
  const auto n = static_cast<std::size_t>(mesh.faceCount());
  FieldSystem system;
  system.start.reserve(n + 1);
  system.diagonal.assign(n, 0.0);
  system.faces.assign(n, 1);
  system.mass.reserve(n);
  system.pull.assign(n, 0.0);
  for (HalfedgeId first : unknowns.halfedge) {
    const FaceId f = TriMesh::face(first);
    int inside = 0;
    for (int k = 0; k < 3; ++k) inside += !mesh.isBoundary(TriMesh::halfedge(f, k));
    system.start.push_back(system.start.back() + inside);
    system.mass.push_back(geometry.area[f]);
  }
  const auto entries = static_cast<std::size_t>(system.start.back());
  system.other.resize(entries);
  system.coupling.resize(entries);
  system.strength.resize(entries);
  parallelFor(mesh.faceCount(), kFacesAtOnce, [&](int i) {
    HalfedgeId h = unknowns.halfedge[static_cast<std::size_t>(i)];
    const FaceId f = TriMesh::face(h);
    int e = system.start[i];
    for (int k = 0; k < 3; ++k, h = TriMesh::next(h)) {
      if (mesh.isBoundary(h)) continue;
      const FaceId g = TriMesh::face(mesh.twin(h));
      const double w = dualWeight(geometry, h, geometry.area[f] + geometry.area[g]);
      system.other[e] = unknowns.of[g];
      system.coupling[e] = -portable::polar(w, -q * transport(mesh, geometry, h)) *
                           std::conj(unknowns.turn[f]) * unknowns.turn[g];
      system.strength[e] = w;
      system.diagonal[i] += w;
      ++e;
    }
  });
  for (const AlignedTerm& t : aligned) {
    const auto i = static_cast<std::size_t>(unknowns.of[t.face]);
    system.diagonal[i] += t.weight;
    system.pull[i] += t.weight * t.direction * std::conj(unknowns.turn[t.face]);
  }
  double mean = 0.0;
  for (double d : system.diagonal) mean += d / mesh.faceCount();
  for (double& d : system.diagonal) d += kShift * mean;
  return system;
}

SparseC matrixOf(const FieldSystem& system) {
  const int n = system.size();
  std::vector<Eigen::Triplet<Complex>> entries;
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, system.diagonal[i]);
    for (int e = system.start[i]; e < system.start[i + 1]; ++e)
      entries.emplace_back(i, system.other[e], system.coupling[e]);
  }
  SparseC A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  return A;
}

/// A start vector that is not constant and depends only on the index of the unknown.
Eigen::VectorXcd startVector(int n) {
  Eigen::VectorXcd x(n);
  for (int i = 0; i < n; ++i) x[i] = portable::polar(1.0, kGoldenAngle * i);
  return x;
}

/// Solves directly; empty if the matrix cannot be factored.
std::vector<Complex> minimiseDirectly(const FieldSystem& system, bool isPulled) {
  const int n = system.size();
  const SparseC A = matrixOf(system);
  linalg::MultifrontalCholesky<Complex> factor;
  const linalg::Graph pattern = linalg::graphOf(A);
  factor.analyze(pattern, linalg::nestedDissection(pattern));
  if (!factor.factor(A)) return {};
  Eigen::VectorXcd x(n);
  if (isPulled) {
    x = factor.solve(Eigen::Map<const Eigen::VectorXcd>(system.pull.data(), n));
  } else {
    x = startVector(n);
    for (int i = 0; i < kInverseIterations; ++i) {
      for (int j = 0; j < n; ++j) x[j] *= system.mass[j];
      x = factor.solve(x);
      x /= x.norm();
    }
  }
  return {x.data(), x.data() + n};
}

/// Coarsens to ever larger patches until the system is small, solves it, and smooths on the way back.
std::vector<Complex> minimise(const FieldSystem& system, bool isPulled) {
  if (system.size() <= kDirectSize) return minimiseDirectly(system, isPulled);
  Patches patches;
  const FieldSystem coarse = pairUp(system, patches);
  if (coarse.size() > kMinShrinking * system.size()) return minimiseDirectly(system, isPulled);
  const std::vector<Complex> onPatches = minimise(coarse, isPulled);
  if (onPatches.empty()) return {};
  std::vector<Complex> x(patches.turn);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] *= onPatches[patches.patch[i]];
  smoothSweeps(system, kSweeps, x);
  return x;
}

Vec3 unit(const Vec3& a) {
  const double n = norm(a);
  return n > 0 ? scaled(a, 1.0 / n) : a;
}

/// Principal directions of the shape operator from vertex normals, weighted by |κ₁ − κ₂| in units
/// of the mean edge length.
std::vector<AlignedTerm> curvatureTerms(const TriMesh& mesh, const Geometry& geometry, int q) {
  const auto edgeVector = [&](HalfedgeId h) {
    return scaled(subtract(mesh.position(mesh.head(h)), mesh.position(mesh.tail(h))),
                  1.0 / geometry.unit);
  };
  PerVertex<Vec3> normal(static_cast<std::size_t>(mesh.vertexCount()), Vec3{0, 0, 0});
  for (FaceId f : mesh.faces()) {
    const Vec3 n = cross(edgeVector(TriMesh::halfedge(f, 0)), edgeVector(TriMesh::halfedge(f, 1)));
    for (VertexId v : mesh.corners(f)) normal[v] = add(normal[v], n);
  }
  std::vector<AlignedTerm> terms;
  for (FaceId f : mesh.faces()) {
    const auto [i, j, l] = mesh.corners(f);
    if (hasNoArea(mesh.position(i), mesh.position(j), mesh.position(l))) continue;
    // Least-squares symmetric S with e·(S e) = Δn·e per edge, in the face's own coordinates.
    Eigen::Matrix3d A;
    Eigen::Vector3d b;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const Complex e = portable::polar(geometry.length[h], geometry.direction[h]);
      const Vec3 dn = subtract(unit(normal[mesh.head(h)]), unit(normal[mesh.tail(h)]));
      A.row(k) << e.real() * e.real(), 2 * e.real() * e.imag(), e.imag() * e.imag();
      b[k] = dot(dn, edgeVector(h));
    }
    const Eigen::Vector3d s = A.fullPivLu().solve(b);
    const double weight = portable::hypot(s[0] - s[2], 2 * s[1]);
    if (!std::isfinite(weight) || weight < kMinBending) continue;
    const double angle = 0.5 * portable::atan2(2 * s[1], s[0] - s[2]);
    terms.push_back({f, std::min(weight, kFullBending), portable::polar(1.0, q * angle)});
  }
  return terms;
}

}  // namespace

Result<FrameField> smoothField(const TriMesh& mesh, const FieldContext& context,
                               const SmoothFieldOptions& options) {
  const Geometry& geometry = context.geometry;
  std::vector<AlignedTerm> aligned;
  if (options.alignToBoundary) aligned = boundaryTerms(mesh, geometry, options.q);
  if (options.alignToCurvature && options.q % 2 == 0) {
    const auto more = curvatureTerms(mesh, geometry, options.q);
    aligned.insert(aligned.end(), more.begin(), more.end());
  }
  for (const HeldDirection& held : options.held)
    aligned.push_back({held.face, kHeldWeight, portable::polar(1.0, options.q * held.angle)});
  const Unknowns unknowns = unknownsOf(mesh, geometry, options.q);
  const std::vector<Complex> x =
      minimise(fieldSystem(mesh, geometry, options.q, unknowns, aligned), !aligned.empty());
  if (x.empty())
    return Failure{ErrorCode::kUnsupported,
                   "field",
                   "The smooth field could not be computed: the surface's geometry is not "
                   "numerically usable.",
                   {}};
  FrameField field;
  field.q = options.q;
  field.angle = PerFace<double>(static_cast<std::size_t>(mesh.faceCount()), 0.0);
  parallelFor(mesh.faceCount(), kFacesAtOnce, [&](int f) {
    const Complex direction =
        x[static_cast<std::size_t>(unknowns.of[FaceId(f)])] * unknowns.turn[FaceId(f)];
    field.angle[FaceId(f)] = portable::arg(direction) / options.q;
  });
  for (const HeldDirection& held : options.held) field.angle[held.face] = held.angle;
  matchPrincipally(mesh, geometry, field);
  return field;
}

}  // namespace hgp
