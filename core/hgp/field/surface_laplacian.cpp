#include "hgp/field/surface_laplacian.h"

#include "hgp/field/mesh_trees.h"

namespace hgp {

Result<SurfaceLaplacian> SurfaceLaplacian::build(const TriMesh& mesh, const FilledSurface& surface,
                                                 const linalg::SeparatorTree& tree) {
  const int n = surface.nodeCount - 1;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(4 * static_cast<std::size_t>(mesh.edgeCount()));
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const int i = surface.node[mesh.tail(h)] - 1;
    const int j = surface.node[mesh.head(h)] - 1;
    const double w = surface.weight[e];
    if (i == j || w == 0.0) continue;
    if (i >= 0) entries.emplace_back(i, i, w);
    if (j >= 0) entries.emplace_back(j, j, w);
    if (i >= 0 && j >= 0) {
      entries.emplace_back(i, j, -w);
      entries.emplace_back(j, i, -w);
    }
  }
  Eigen::SparseMatrix<double> L(n, n);
  L.setFromTriplets(entries.begin(), entries.end());
  SurfaceLaplacian result;
  result.factor_.analyze(linalg::graphOf(L), nodeTree(mesh, surface, tree));
  if (!result.factor_.factor(L))
    return Failure{ErrorCode::kUnsupported,
                   "field",
                   "The Laplacian of the surface could not be factored: all points are equal, or "
                   "coordinates have extremely different sizes.",
                   {}};
  return result;
}

Eigen::MatrixXd SurfaceLaplacian::solve(const Eigen::MatrixXd& rhs) const {
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(rhs.rows(), rhs.cols());
  if (rhs.rows() > 1) u.bottomRows(rhs.rows() - 1) = factor_.solve(rhs.bottomRows(rhs.rows() - 1));
  return u;
}

}  // namespace hgp
