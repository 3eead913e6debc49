// A graph of clusters.  Role: the graphs that multilevel bisection coarsens, cuts and refines.
#pragma once

#include <vector>

namespace hgp::linalg {

/// A graph whose vertices represent clusters; weights count the vertices and edges that they represent.
struct WeightedGraph {
  std::vector<int> start{0};
  std::vector<int> neighbours;
  std::vector<int> edgeWeight;    ///< parallel to `neighbours`
  std::vector<int> vertexWeight;  ///< |V|

  int size() const { return static_cast<int>(start.size()) - 1; }
};

/// A coarser copy of a graph.
struct CoarseLevel {
  WeightedGraph graph;
  std::vector<int> cluster;  ///< vertex of the finer graph → vertex here
};

}  // namespace hgp::linalg
