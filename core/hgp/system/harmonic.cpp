#include "hgp/system/harmonic.h"

namespace hgp {

HarmonicSystem harmonicSystem(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                              const ReducedUnknowns& unknowns, int q,
                              const std::vector<VertexId>& cones) {
  PerVertex<char> isCone(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (VertexId v : cones) isCone[v] = 1;

  HarmonicSystem system;
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(7 * static_cast<std::size_t>(mesh.vertexCount()));
  for (VertexId v : mesh.vertices()) {
    if (mesh.isIsolated(v) || mesh.isBoundary(v) || isCone[v]) continue;
    const int row = static_cast<int>(system.rowVertex.size());
    system.rowVertex.push_back(v);
    double total = 0.0;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const CornerWeights w = meanValueWeights(geometry, h);
      total += w.toHead + w.toThird;
    }
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      const CornerWeights w = meanValueWeights(geometry, h);
      const Complex back = rotation(-unknowns.turn[cut.copy[h]], q) / total;
      entries.emplace_back(row, cut.copy[h].i, back * (w.toHead + w.toThird));
      entries.emplace_back(row, cut.copy[TriMesh::next(h)].i, -back * w.toHead);
      entries.emplace_back(row, cut.copy[TriMesh::previous(h)].i, -back * w.toThird);
    }
  }
  SparseRows overCopies(static_cast<Eigen::Index>(system.rowVertex.size()), cut.vertexCount());
  overCopies.setFromTriplets(entries.begin(), entries.end());
  system.rows = overCopies * unknowns.copies;
  // Translations cancel against themselves along a chain; only rounding is left of them.
  system.rows.prune(
      [](Eigen::Index, Eigen::Index, const Complex& value) { return std::abs(value) > 1e-14; });
  return system;
}

}  // namespace hgp
