#include "hgp/field/cone_angles.h"

#include <algorithm>

#include "hgp/base/turns.h"

namespace hgp {

namespace {

/// K_asked − K per node; what Gauss–Bonnet leaves is spread over the loops that are not given.
Eigen::VectorXd askedGap(const TriMesh& mesh, const FilledSurface& surface,
                         const Geometry& geometry, const AngleQuestion& question) {
  Eigen::VectorXd gap = Eigen::VectorXd::Zero(surface.nodeCount);
  for (VertexId v : mesh.vertices())
    if (surface.isInterior(mesh, v))
      gap[surface.node[v]] = geometry.angleSum[v] - turnAngle(question.k[v], question.q);
  std::vector<int> open = surface.loopNode;
  for (const LoopAngle& loop : question.loops) {
    const int node = surface.loopNode[static_cast<std::size_t>(loop.index)];
    gap[node] = coneCurvature(-loop.turning, question.q) -
                surface.curvature[static_cast<std::size_t>(node)];
    open.erase(std::find(open.begin(), open.end(), node));
  }
  const double left = gap.sum();
  for (const int node : open) gap[node] = -left / static_cast<double>(open.size());
  gap.array() -= gap.mean();
  return gap;
}

}  // namespace

PerHalfedge<double> coneAngles(const TriMesh& mesh, const FieldContext& context,
                               const AngleQuestion& question) {
  const FilledSurface& surface = context.surface;
  const Geometry& geometry = context.geometry;
  const Eigen::VectorXd u = context.laplacian.solve(askedGap(mesh, surface, geometry, question));
  PerHalfedge<double> angle = geometry.cornerAngle;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e), twin = mesh.twin(h);
    if (!twin.isValid()) continue;
    const double flow =
        surface.weight[e] * (u[surface.node[mesh.tail(h)]] - u[surface.node[mesh.head(h)]]);
    // The corners at the tail of h, and those at its head.
    for (const HalfedgeId corner : {h, TriMesh::next(twin)}) angle[corner] -= 0.5 * flow;
    for (const HalfedgeId corner : {TriMesh::next(h), twin}) angle[corner] += 0.5 * flow;
  }
  return angle;
}

}  // namespace hgp
