// Symbolic factorization: the structure of the factor and its cost.  Role: planning before numbers are computed.
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/linalg/graph/graph.h"

namespace hgp::linalg {

struct SymbolicOptions {
  /// Optional class of each unknown (by original index): a supernode never mixes an unknown of class
  /// 0 with others, and class 1 spreads to all ancestors. Empty: everything is class 0.
  std::vector<char> dynamic = {};
  /// Merge a child node into its parent when the estimated time falls (explicit zeros against
  /// overhead). Off only in tests.
  bool amalgamate = true;
};

/// The factor's shape. Unknowns are renumbered by elimination position; node t ("supernode")
/// eliminates positions nodeStart[t] … nodeStart[t + 1] − 1 as one dense panel whose further rows are
/// rows[rowStart[t]] … rows[rowStart[t + 1] − 1], ascending positions beyond the node.
struct SymbolicFactor {
  std::vector<int> order;     ///< position → unknown
  std::vector<int> position;  ///< unknown → position
  std::vector<int> nodeStart;
  std::vector<int> parent;  ///< assembly forest; parent[t] > t or −1; postordered
  std::vector<std::int64_t> rowStart;
  std::vector<int> rows;
  std::vector<char> dynamicNode;  ///< class of each node (all 0 without SymbolicOptions::dynamic)

  int size() const { return static_cast<int>(order.size()); }
  int nodeCount() const { return static_cast<int>(parent.size()); }
  int pivots(int t) const { return nodeStart[t + 1] - nodeStart[t]; }
  int rowCount(int t) const { return static_cast<int>(rowStart[t + 1] - rowStart[t]); }
  const int* rowsOf(int t) const { return rows.data() + rowStart[t]; }
};

/// Cost of a Cholesky factorization. One multiply-add is 2 flops in real, 8 in complex arithmetic.
struct FactorCost {
  double multiplyAdds = 0;       ///< Σ over panels of s³/6 + s²r/2 + s r²/2
  std::int64_t entries = 0;      ///< stored numbers of the factor (full panels)
  std::int64_t peakEntries = 0;  ///< factor + live contribution blocks at the worst moment
};

/// Elimination tree, column counts, supernodes, relaxed amalgamation and row structure of a
/// symmetric pattern eliminated in `order` (a permutation). The result's order is a postordering of
/// it: equal fill, different numbering. O(edges · α + rows of the factor).
SymbolicFactor analyze(const Graph& pattern, const std::vector<int>& order,
                       const SymbolicOptions& options = {});

/// The nanoseconds, roughly, in which a real front of each node is assembled and eliminated; −1 for nodes of another class.
/// Sharing a factorization among threads needs only their ratios.
std::vector<double> nodeTimes(const SymbolicFactor& symbolic, int nodeClass = -1);

/// Cost over the nodes of one class (0 or 1), or of all with dynamicClass = −1.
FactorCost factorCost(const SymbolicFactor& symbolic, int dynamicClass = -1);

}  // namespace hgp::linalg
