// S with every boundary loop shrunk to one node: a closed surface of genus g on which a loop of
// turning index l behaves like a cone of angle index −l.  Role: one mechanism for cones and loops.
#pragma once

#include <vector>

#include "hgp/mesh/geometry.h"
#include "hgp/mesh/topology.h"

namespace hgp {

struct FilledSurface {
  PerVertex<int> node;  ///< node of each vertex; all vertices of a loop share one; −1 isolated
  int nodeCount = 0;
  std::vector<int> loopNode;      ///< per loop of Topology::loops
  PerEdge<double> weight;         ///< ½(cot α + cot β), clamped positive; 0 on boundary edges
  std::vector<double> curvature;  ///< per node; Σ = 2π(2 − 2g); a loop has its turning angle + 2π

  bool isInterior(const TriMesh& mesh, VertexId v) const {
    return node[v] >= 0 && !mesh.isBoundary(v);
  }
};

FilledSurface fillBoundary(const TriMesh& mesh, const Topology& topology, const Geometry& geometry);

/// The prescribed curvature of a node: 2π(1 − k/q) inside, 2π(1 + l/q) at a loop, for which k = −l.
inline double coneCurvature(double k, int q) { return 2.0 * kPi * (1.0 - k / q); }

}  // namespace hgp
