// The order within one leaf of a dissection.  Role: minimum degree that accounts for the leaf's
// neighbourhood; for dissections and for trees taken from another graph.
#pragma once

#include <vector>

#include "hgp/linalg/graph/graph.h"

namespace hgp::linalg {

class LeafOrder {
 public:
  /// @param width  1: the matrix couples neighbours in `graph`; 2: also those at distance two,
  ///               except through vertices of more than denseDegree neighbours
  LeafOrder(const Graph& graph, int width, int denseDegree);

  /// `vertices` in the order to eliminate them.
  std::vector<int> order(const std::vector<int>& vertices);

 private:
  const Graph& g_;
  int width_, denseDegree_;
  std::vector<int> local_;
};

}  // namespace hgp::linalg
