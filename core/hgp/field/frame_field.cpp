#include "hgp/field/frame_field.h"

#include <cmath>

namespace hgp {
namespace {

/// On symmetric surfaces a direction can lie exactly between two others. This close to a tie the lower one is taken;
/// otherwise rounding errors, which differ between builds, would determine the cones.
constexpr double kTieShare = 1e-7;

/// How far the field turns beyond transport across h, in radians. Antisymmetric even for half a turn, where the sign
/// is arbitrary: otherwise the indices of a field would not satisfy Lemma 6.2.
double adjustment(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                  HalfedgeId h) {
  const HalfedgeId own = mesh.halfedge(mesh.edge(h));
  const FaceId f = TriMesh::face(own), g = TriMesh::face(mesh.twin(own));
  const double turned = field.angle[g] + turnAngle(field.matching[own], field.q);
  const double angle = principalAngle(turned - field.angle[f] - transport(mesh, geometry, own));
  return own == h ? angle : -angle;
}

}  // namespace

int loopHolonomy(const FrameField& field, const DualLoop& loop) {
  long long sum = 0;
  for (HalfedgeId h : loop.crossed) sum += field.matching[h];
  return reduceTurn(sum, field.q);
}

void matchPrincipally(const TriMesh& mesh, const Geometry& geometry, FrameField& field) {
  field.matching = PerHalfedge<int>(static_cast<std::size_t>(mesh.halfedgeCount()), 0);
  for (HalfedgeId h : mesh.halfedges()) {
    const HalfedgeId twin = mesh.twin(h);
    if (!twin.isValid() || twin < h) continue;
    const double gap = field.angle[TriMesh::face(h)] + transport(mesh, geometry, h) -
                       field.angle[TriMesh::face(twin)];
    field.matching[h] = static_cast<int>(std::floor(gap * field.q / (2.0 * kPi) + 0.5 - kTieShare));
    field.matching[twin] = -field.matching[h];
  }
}

int inducedAngleIndex(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                      VertexId v) {
  double sum = curvature(mesh, geometry, v);
  for (HalfedgeId h : outgoingHalfedges(mesh, v))
    sum += adjustment(mesh, geometry, field, mesh.twin(h));
  return field.q - static_cast<int>(std::lround(sum * field.q / (2.0 * kPi)));
}

int inducedTurning(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                   const BoundaryLoop& loop) {
  double sum = 0.0;
  for (HalfedgeId boundary : loop.halfedges) {
    const VertexId v = mesh.tail(boundary);
    sum += curvature(mesh, geometry, v);
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      if (!mesh.isBoundary(h)) sum += adjustment(mesh, geometry, field, mesh.twin(h));
  }
  return static_cast<int>(std::lround(sum * field.q / (2.0 * kPi)));
}

double squaredTurn(const TriMesh& mesh, const Geometry& geometry, const FrameField& field) {
  double sum = 0.0;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h)) continue;
    const double turn = adjustment(mesh, geometry, field, h);
    sum += turn * turn;
  }
  return sum;
}

}  // namespace hgp
