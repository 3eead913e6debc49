#include "hgp/field/handle_basis.h"

namespace hgp {
namespace {

/// +1 when h is the edge's own halfedge, −1 when it is its twin.
double sign(const TriMesh& mesh, HalfedgeId h) {
  return mesh.halfedge(mesh.edge(h)) == h ? 1.0 : -1.0;
}

}  // namespace

HandleBasis computeHandleBasis(const TriMesh& mesh, const FilledSurface& surface,
                               const SurfaceLaplacian& laplacian) {
  HandleBasis basis;
  basis.loops = handleGenerators(mesh);
  const auto count = static_cast<Eigen::Index>(basis.loops.size());
  Eigen::MatrixXd divergence = Eigen::MatrixXd::Zero(surface.nodeCount, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (HalfedgeId h : basis.loops[static_cast<std::size_t>(i)].crossed) {
      const double w = surface.weight[mesh.edge(h)];
      divergence(surface.node[mesh.tail(h)], i) += w;
      divergence(surface.node[mesh.head(h)], i) -= w;
    }
  }
  // L f = div(w ξ⁰) makes ξ⁰ + df co-closed. Column blocks bound the memory of the solve.
  basis.potential.resize(surface.nodeCount, count);
  for (Eigen::Index i = 0; i < count; i += 32) {
    const Eigen::Index block = std::min<Eigen::Index>(32, count - i);
    basis.potential.middleCols(i, block) = laplacian.solve(divergence.middleCols(i, block));
  }

  basis.periods = Eigen::MatrixXd::Zero(count, count);
  PerEdge<double> crossing(static_cast<std::size_t>(mesh.edgeCount()), 0.0);
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto& own = basis.loops[static_cast<std::size_t>(i)].crossed;
    for (HalfedgeId h : own) crossing[mesh.edge(h)] += sign(mesh, h);
    for (Eigen::Index j = 0; j < count; ++j) {
      for (HalfedgeId h : basis.loops[static_cast<std::size_t>(j)].crossed) {
        const double step = basis.potential(surface.node[mesh.head(h)], i) -
                            basis.potential(surface.node[mesh.tail(h)], i);
        basis.periods(j, i) +=
            surface.weight[mesh.edge(h)] * (crossing[mesh.edge(h)] * sign(mesh, h) + step);
      }
    }
    for (HalfedgeId h : own) crossing[mesh.edge(h)] = 0.0;
  }
  basis.periods = (0.5 * (basis.periods + basis.periods.transpose())).eval();
  return basis;
}

PerEdge<double> combineForms(const TriMesh& mesh, const FilledSurface& surface,
                             const HandleBasis& basis, const Eigen::VectorXd& c) {
  PerEdge<double> form(static_cast<std::size_t>(mesh.edgeCount()), 0.0);
  if (c.size() == 0) return form;
  for (Eigen::Index i = 0; i < c.size(); ++i)
    for (HalfedgeId h : basis.loops[static_cast<std::size_t>(i)].crossed)
      form[mesh.edge(h)] += c[i] * sign(mesh, h);
  const Eigen::VectorXd f = basis.potential * c;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h)) continue;
    form[e] += f[surface.node[mesh.head(h)]] - f[surface.node[mesh.tail(h)]];
  }
  return form;
}

}  // namespace hgp
