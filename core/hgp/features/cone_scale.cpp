#include "hgp/features/cone_scale.h"

#include <Eigen/SparseCore>
#include <algorithm>

#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/factor.h"

namespace hgp {
namespace {

/// Bounds of a cotangent weight, in units of an equilateral triangle's, as for the Laplacian of the filled surface.
constexpr double kSmallestWeight = 1e-3, kLargestWeight = 1e3;

}  // namespace

PerVertex<double> coneScale(const TriMesh& mesh, const FieldContext& context,
                            const AlignedField& field) {
  const Geometry& geometry = context.geometry;
  const auto n = static_cast<Eigen::Index>(mesh.vertexCount());
  PerVertex<double> u(at(mesh.vertexCount()), 0.0);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 1);
  std::vector<int> units(at(mesh.vertexCount()), 0);
  for (std::size_t i = 0; i < field.index.size(); ++i) {
    const int node = static_cast<int>(i) - mesh.vertexCount();
    const VertexId v =
        node < 0 ? VertexId(static_cast<int>(i)) : mesh.tail(field.sectors.list[at(node)].first);
    if (node >= 0 || !field.sectors.isOnFeature[v]) units[at(v.i)] += field.index[i];
  }
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    double w = oppositeCotangent(geometry, h);
    if (!mesh.isBoundary(h)) w += oppositeCotangent(geometry, mesh.twin(h));
    w = std::clamp(0.5 * w, kSmallestWeight, kLargestWeight);
    const int a = mesh.tail(h).i, b = mesh.head(h).i;
    for (const int i : {a, b}) entries.emplace_back(i, i, w);
    entries.emplace_back(a, b, -w);
    entries.emplace_back(b, a, -w);
  }
  bool isPinned = false;
  for (VertexId v : mesh.vertices()) {
    // K_asked − K is the angle that the vertex has more than asked.
    rhs(v.i, 0) = mesh.isIsolated(v) ? 0.0 : geometry.angleSum[v] - units[at(v.i)] * kPi / 2.0;
    if (!isPinned || mesh.isIsolated(v)) entries.emplace_back(v.i, v.i, 1.0);
    isPinned = isPinned || !mesh.isIsolated(v);
  }
  Eigen::SparseMatrix<double> L(n, n);
  L.setFromTriplets(entries.begin(), entries.end());
  linalg::MultifrontalCholesky<double> factor;
  factor.analyze(linalg::graphOf(L), context.tree);
  if (!factor.factor(L)) return u;
  const Eigen::MatrixXd x = factor.solve(rhs);
  for (VertexId v : mesh.vertices()) u[v] = x(v.i, 0);
  std::vector<double> sorted = u.raw();
  auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  for (double& value : u.raw()) value -= *middle;
  return u;
}

}  // namespace hgp
