#include "hgp/optimize/harmonic_rows.h"

#include <algorithm>

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

SparseRows squareRows(const SeamlessSystem& system, std::vector<std::array<int, 2>> zeros) {
  const SparseRows& rows = system.harmonic.rows;
  std::vector<int> rowOf(static_cast<std::size_t>(system.unknowns.count), -1);
  for (std::size_t r = 0; r < system.harmonic.rowVertex.size(); ++r)
    rowOf[static_cast<std::size_t>(system.unknowns.vertexUnknown[system.harmonic.rowVertex[r]])] =
        static_cast<int>(r);
  std::sort(zeros.begin(), zeros.end());
  auto zero = zeros.begin();
  RowBuilder square(system.unknowns.count, system.unknowns.count,
                    static_cast<std::size_t>(rows.nonZeros()) + zeros.size());
  for (int unknown = 0; unknown < system.unknowns.count; ++unknown) {
    const int r = rowOf[static_cast<std::size_t>(unknown)];
    if (r >= 0)
      for (SparseRows::InnerIterator it(rows, r); it; ++it)
        square.add(static_cast<int>(it.col()), it.value());
    for (; zero != zeros.end() && (*zero)[0] == unknown; ++zero) square.add((*zero)[1], 0.0);
    square.endRow(-1.0);
  }
  return square.take();
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
