// The elimination tree and its column counts.  Role: the skeleton of a symbolic factorization.
#pragma once

#include <vector>

#include "hgp/linalg/graph/graph.h"

namespace hgp::linalg {

/// parent[k] = the first position that position k couples to once all before it are eliminated;
/// −1 for roots. Liu's algorithm with path compression: O(edges · α).
std::vector<int> eliminationTree(const Graph& pattern, const std::vector<int>& order,
                                 const std::vector<int>& position);

/// A postordering of a forest: entry k is the node visited k-th; children in ascending order.
std::vector<int> postorder(const std::vector<int>& parent);

/// Entries of each factor column, the diagonal included, for a postordered elimination tree
/// (Gilbert, Ng and Peyton): O(edges · α).
std::vector<int> columnCounts(const Graph& pattern, const std::vector<int>& order,
                              const std::vector<int>& position, const std::vector<int>& parent);

}  // namespace hgp::linalg
