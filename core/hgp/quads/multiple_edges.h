// Quads that a file cannot hold.  Role: files name edges by their ends, so that two of them with the same ends
// are one to whoever reads them.
#pragma once

#include "hgp/quads/quads.h"

namespace hgp {

struct MultipleEdges {
  /// Pairs of vertices that more than one edge joins, and loops from a vertex to itself: around handles of
  /// one or two cells, and around two cones that are so close. None is left after kMostHalvings.
  int pairs = 0;
  /// Quads that are alone at a vertex, a cone of k = 1, and meet themselves there, in whatever grid. The pair
  /// of vertices that each has twice is not among `pairs`.
  int foldedQuads = 0;
};
MultipleEdges countMultipleEdges(const QuadMesh& quads);

/// Each doubles the number of edges of a cycle, and three are a polygon.
inline constexpr int kMostHalvings = 2;

}  // namespace hgp
