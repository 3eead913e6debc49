#include "hgp/field/filled_surface.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/parallel.h"
#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// Weights below this share of a well-shaped edge's (1/√3) would make the Laplacian indefinite or
/// singular; any positive weights give a valid connection, so clamping costs smoothness only.
constexpr double kMinWeight = 0.05;
constexpr double kLargestWeight = 20.0;
/// Edges that a thread takes at a time.
constexpr int kEdgesAtOnce = 1024;

}  // namespace

FilledSurface fillBoundary(const TriMesh& mesh, const Topology& topology,
                           const Geometry& geometry) {
  FilledSurface s;
  s.node = PerVertex<int>(static_cast<std::size_t>(mesh.vertexCount()), -1);
  for (const BoundaryLoop& loop : topology.loops) {
    s.loopNode.push_back(s.nodeCount);
    for (HalfedgeId h : loop.halfedges) s.node[mesh.tail(h)] = s.nodeCount;
    ++s.nodeCount;
  }
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && s.node[v] < 0) s.node[v] = s.nodeCount++;

  s.weight = PerEdge<double>(static_cast<std::size_t>(mesh.edgeCount()), 0.0);
  parallelFor(mesh.edgeCount(), kEdgesAtOnce, [&](int edge) {
    const EdgeId e(edge);
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h)) return;
    const double w =
        0.5 * (oppositeCotangent(geometry, h) + oppositeCotangent(geometry, mesh.twin(h)));
    s.weight[e] = std::clamp(w, kMinWeight, kLargestWeight);
  });

  s.curvature.assign(static_cast<std::size_t>(s.nodeCount), 0.0);
  for (int node : s.loopNode) s.curvature[static_cast<std::size_t>(node)] = 2.0 * kPi;
  for (VertexId v : mesh.vertices())
    if (s.node[v] >= 0)
      s.curvature[static_cast<std::size_t>(s.node[v])] += curvature(mesh, geometry, v);
  return s;
}

}  // namespace hgp
