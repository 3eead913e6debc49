// The harmonic rows as a square matrix, and trees of unknowns.  Role: what forms hand to SchurLu and PartialCholesky.
#pragma once

#include <array>
#include <vector>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// Whether an unknown is that of a vertex with a harmonic row.
std::vector<char> unknownsWithRows(const SeamlessSystem& system);

/// count × count, each row at the index of its vertex' unknown; the other rows are empty.
/// @param zeros  row and column of entries that are stored whatever their value
SparseRows squareRows(const SeamlessSystem& system, std::vector<std::array<int, 2>> zeros = {});

/// The vertices' tree over unknowns. Those that are not vertices are appended to its root.
linalg::SeparatorTree unknownTree(const SeamlessSystem& system,
                                  const linalg::SeparatorTree& vertexTree);

/// A dissection of the mesh with separators of width 2 as a tree of H; dissecting H's own graph takes three times as
/// long. The other unknowns, translations that couple to whole seams, are inserted where their neighbours allow.
/// @param number  per vertex, its row of H, ascending from 0; −1 where it has none
linalg::SeparatorTree formTree(const linalg::SeparatorTree& wideTree,
                               const std::vector<int>& number,
                               const Eigen::SparseMatrix<Complex>& H);

}  // namespace hgp
