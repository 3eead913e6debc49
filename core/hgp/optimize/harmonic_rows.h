// The harmonic rows as a square matrix.  Role: what exactForm and HarmonicBasis hand to SchurLu.
#pragma once

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// Whether an unknown is that of a vertex with a harmonic row.
std::vector<char> unknownsWithRows(const SeamlessSystem& system);

/// count × count, each row at the index of its vertex' unknown; the other rows are empty.
SparseRows squareRows(const SeamlessSystem& system);

/// The vertices' tree over unknowns. Those that are not vertices are appended to its root.
linalg::SeparatorTree unknownTree(const SeamlessSystem& system,
                                  const linalg::SeparatorTree& vertexTree);

}  // namespace hgp
