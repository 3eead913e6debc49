#include "hgp/parametrize/strategy/frames_of_metric.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/field/angle_structure.h"
#include "hgp/optimize/frames.h"

namespace hgp {
namespace {

/// Whether angles sum to π everywhere: those of triangles thinner than float64 resolves do not.
bool areTriangles(const TriMesh& mesh, const Geometry& geometry) {
  constexpr double kAccepted = 1e-9;
  for (FaceId f : mesh.faces()) {
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) sum += geometry.cornerAngle[TriMesh::halfedge(f, k)];
    if (!(std::abs(sum - kPi) < kAccepted)) return false;
  }
  return true;
}

}  // namespace

std::shared_ptr<const SeamRotations> framesOfShapes(const TriMesh& mesh, const SeamlessSetup& setup,
                                                    const PerHalfedge<double>& length) {
  const FieldContext& own = *setup.context;
  FieldContext other{own.topology, geometryOfShapes(mesh, length), {}, own.tree, {}, {}, {}};
  if (!areTriangles(mesh, other.geometry)) return nullptr;
  other.surface = fillBoundary(mesh, other.topology, other.geometry);
  for (double& weight : other.surface.weight.raw())
    if (weight > 0.0) weight = 1.0;
  if (!prepareConnection(mesh, other)) return nullptr;
  const Result<PrescribedField> field = prescribedField(mesh, other, toSpec(setup.field.spec));
  if (!field) return nullptr;
  SeamRotations seams = seamRotations(mesh, setup.cut, field->field);
  if (seams.rotation.raw() != setup.seams.rotation.raw()) return nullptr;
  for (FaceId f : mesh.faces()) {
    const LinearParts parts = linearParts(own.geometry, f);
    Complex similarity = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      similarity += parts.similarity[k] * other.geometry.corner[f][k];
    seams.frameAngle[f] -= portable::arg(similarity);
  }
  return std::make_shared<const SeamRotations>(std::move(seams));
}

std::shared_ptr<const SeamRotations> framesOfAngles(const TriMesh& mesh,
                                                    const SeamlessSetup& setup) {
  const std::optional<PerHalfedge<double>> angle =
      angleStructure(mesh, *setup.context, setup.field.spec);
  if (!angle) return nullptr;
  PerHalfedge<double> length(static_cast<std::size_t>(mesh.halfedgeCount()), 0.0);
  for (HalfedgeId h : mesh.halfedges()) length[h] = portable::sin((*angle)[TriMesh::previous(h)]);
  return framesOfShapes(mesh, setup, length);
}

std::shared_ptr<const SeamRotations> AngleFrames::get(const TriMesh& mesh,
                                                      const SeamlessSetup& setup) {
  if (!isKnown_) frames_ = framesOfAngles(mesh, setup);
  isKnown_ = true;
  return frames_;
}

std::shared_ptr<const SeamRotations> framesOfMap(const TriMesh& mesh, const SeamlessSetup& setup,
                                                 const std::vector<Complex>& z) {
  const auto at = [&](HalfedgeId h) { return z[static_cast<std::size_t>(setup.cut.copy[h].i)]; };
  PerHalfedge<double> length(static_cast<std::size_t>(mesh.halfedgeCount()), 0.0);
  for (HalfedgeId h : mesh.halfedges()) {
    length[h] = portable::abs(at(TriMesh::next(h)) - at(h));
    if (!(length[h] > 0.0)) return nullptr;
  }
  return framesOfShapes(mesh, setup, length);
}

}  // namespace hgp
