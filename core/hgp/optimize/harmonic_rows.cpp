#include "hgp/optimize/harmonic_rows.h"

#include <numeric>

#include "hgp/base/check.h"

namespace hgp {

std::vector<char> unknownsWithRows(const SeamlessSystem& system) {
  std::vector<char> hasRow(static_cast<std::size_t>(system.unknowns.count), 0);
  for (VertexId v : system.harmonic.rowVertex) {
    const int unknown = system.unknowns.vertexUnknown[v];
    HGP_CHECK(unknown >= 0, "vertex %d has a harmonic row and no unknown", v.i);
    hasRow[static_cast<std::size_t>(unknown)] = 1;
  }
  return hasRow;
}

SparseRows squareRows(const SeamlessSystem& system) {
  const SparseRows& rows = system.harmonic.rows;
  std::vector<int> start(static_cast<std::size_t>(system.unknowns.count) + 1, 0);
  for (std::size_t r = 0; r < system.harmonic.rowVertex.size(); ++r) {
    const int unknown = system.unknowns.vertexUnknown[system.harmonic.rowVertex[r]];
    start[static_cast<std::size_t>(unknown) + 1] =
        static_cast<int>(rows.outerIndexPtr()[r + 1] - rows.outerIndexPtr()[r]);
  }
  // Unknowns ascend with their vertices, so that the entries stay sorted.
  std::partial_sum(start.begin(), start.end(), start.begin());
  return Eigen::Map<const SparseRows>(system.unknowns.count, system.unknowns.count, rows.nonZeros(),
                                      start.data(), rows.innerIndexPtr(), rows.valuePtr());
}

linalg::SeparatorTree unknownTree(const SeamlessSystem& system,
                                  const linalg::SeparatorTree& vertexTree) {
  const ReducedUnknowns& unknowns = system.unknowns;
  linalg::SeparatorTree tree = linalg::restrictTree(vertexTree, unknowns.vertexUnknown.raw());
  std::vector<char> isVertex(static_cast<std::size_t>(unknowns.count), 0);
  for (int unknown : tree.order) isVertex[static_cast<std::size_t>(unknown)] = 1;
  for (int unknown = 0; unknown < unknowns.count; ++unknown)
    if (!isVertex[static_cast<std::size_t>(unknown)]) tree.order.push_back(unknown);
  tree.nodeStart.back() = unknowns.count;
  return tree;
}

linalg::SeparatorTree formTree(const linalg::SeparatorTree& wideTree,
                               const std::vector<int>& number,
                               const Eigen::SparseMatrix<Complex>& H) {
  const linalg::SeparatorTree vertices = linalg::restrictTree(wideTree, number);
  // Only the neighbours of appended unknowns are needed.
  linalg::Graph appended;
  appended.start.assign(vertices.order.size() + 1, 0);
  for (auto j = static_cast<Eigen::Index>(vertices.order.size()); j < H.cols(); ++j) {
    for (Eigen::SparseMatrix<Complex>::InnerIterator it(H, j); it; ++it)
      if (it.row() != j) appended.neighbours.push_back(static_cast<int>(it.row()));
    appended.start.push_back(static_cast<int>(appended.neighbours.size()));
  }
  return linalg::appendVertices(vertices, appended);
}

}  // namespace hgp
