// Counts edges with the same end vertices.  Role: files identify edges by their ends, so that readers cannot tell such
// edges apart.
#pragma once

#include <set>

#include "hgp/quads/quads.h"

namespace hgp {

struct MultipleEdges {
  /// Pairs of vertices that more than one edge joins, and loops from a vertex to itself: around handles of
  /// one or two cells, and around two cones that are so close. None is left after kMaxHalvings.
  int pairs = 0;
  /// Quads that are the only one at a vertex, a cone of k = 1, so that two of their edges coincide in any grid. The pair
  /// of end vertices of these edges is not among `pairs`.
  int foldedQuads = 0;
};
MultipleEdges countMultipleEdges(const QuadMesh& quads);

/// The same with the pairs, each in ascending order.
struct MultipleEdgePairs {
  std::set<std::array<int, 2>> pairs;
  int foldedQuads = 0;
};
MultipleEdgePairs findMultipleEdges(const QuadMesh& quads);

/// Each doubles the number of edges of a cycle, and three are a polygon.
inline constexpr int kMaxHalvings = 2;

}  // namespace hgp
