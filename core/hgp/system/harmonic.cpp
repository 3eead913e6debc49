#include "hgp/system/harmonic.h"

#include "hgp/base/parallel.h"
#include "hgp/system/row_builder.h"

namespace hgp {
namespace {

/// The two terms of a translation cancel along its chain; smaller sums are rounding errors.
constexpr double kMinWeight = 1e-14;
/// Triangles that a thread takes at a time.
constexpr int kFacesAtOnce = 1024;

}  // namespace

HarmonicSystem harmonicSystem(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                              const ReducedUnknowns& unknowns, int q,
                              const std::vector<VertexId>& cones, WeightKind kind) {
  PerVertex<char> isCone(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : cones) isCone[v] = 1;

  const auto hasRow = [&](VertexId v) { return !mesh.isBoundary(v) && !isCone[v]; };
  HarmonicSystem system;
  RowBuilder builder(unknowns.count, mesh.vertexCount(),
                     7 * static_cast<std::size_t>(mesh.vertexCount()));
  const auto addCopy = [&](HalfedgeId h, const Complex& factor) {
    for (SparseRows::InnerIterator it(unknowns.copies, cut.copy[h].i); it; ++it)
      builder.add(static_cast<int>(it.col()), factor * it.value());
  };
  std::vector<CornerWeights> weights(static_cast<std::size_t>(mesh.halfedgeCount()));
  parallelFor(mesh.faceCount(), kFacesAtOnce, [&](int f) {
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(FaceId(f), k);
      if (hasRow(mesh.tail(h))) weights[at(h.i)] = cornerWeights(kind, mesh, geometry, h);
    }
  });
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || !hasRow(v)) continue;
    system.rowVertex.push_back(v);
    double total = 0.0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      total += weights[at(h.i)].toHead + weights[at(h.i)].toThird;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const CornerWeights& w = weights[at(h.i)];
      const Complex back = rotation(-unknowns.turn[cut.copy[h]], q) / total;
      addCopy(h, back * (w.toHead + w.toThird));
      addCopy(TriMesh::next(h), -back * w.toHead);
      addCopy(TriMesh::previous(h), -back * w.toThird);
    }
    builder.endRow(kMinWeight);
  }
  system.rows = builder.take();
  return system;
}

}  // namespace hgp
