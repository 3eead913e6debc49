#include "hgp/field/open_turning.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace hgp {
namespace {

/// The integers nearest to `natural` with the given sum, each above its lower bound q/2·Σ(1 − t_v).
std::vector<int> roundWithSum(const std::vector<double>& natural, long long sum,
                              const std::vector<double>& lower) {
  std::vector<int> rounded(natural.size());
  for (std::size_t j = 0; j < natural.size(); ++j)
    rounded[j] = static_cast<int>(std::max(std::round(natural[j]), std::floor(lower[j]) + 1.0));
  long long left = sum - std::accumulate(rounded.begin(), rounded.end(), 0LL);
  while (left != 0 && !rounded.empty()) {
    const int step = left > 0 ? 1 : -1;
    int best = -1;
    double bestCost = 0.0;
    for (std::size_t j = 0; j < natural.size(); ++j) {
      if (rounded[j] + step <= lower[j]) continue;
      const double cost =
          std::abs(rounded[j] + step - natural[j]) - std::abs(rounded[j] - natural[j]);
      if (best < 0 || cost < bestCost) best = static_cast<int>(j), bestCost = cost;
    }
    if (best < 0) return {};
    rounded[static_cast<std::size_t>(best)] += step;
    left -= step;
  }
  return rounded;
}

/// Fluxes φ through the nodes of the open loops for which the cone metric has the same u on all of them: with Σ φ
/// fixed, u = u₀ + G φ at these nodes.
std::vector<double> equalFluxes(const FieldContext& context, const HolonomySpec& spec,
                                const std::vector<int>& open) {
  const FilledSurface& surface = context.surface;
  const auto nodeOf = [&](Eigen::Index i) {
    return surface.loopNode[static_cast<std::size_t>(open[static_cast<std::size_t>(i)])];
  };
  const auto n = static_cast<Eigen::Index>(open.size());
  const Eigen::VectorXd gap = curvatureGap(surface, spec);
  const double total = -gap.sum();
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(surface.nodeCount, n);
  const int anchor = nodeOf(0);
  rhs.col(0) = gap;
  rhs(anchor, 0) += total;
  for (Eigen::Index i = 1; i < n; ++i) {
    rhs(anchor, i) = -1.0;
    rhs(nodeOf(i), i) = 1.0;
  }
  const Eigen::MatrixXd u = context.laplacian.solve(rhs);
  Eigen::MatrixXd G(n - 1, n - 1);
  Eigen::VectorXd b(n - 1);
  for (Eigen::Index i = 1; i < n; ++i) {
    const int node = nodeOf(i);
    b[i - 1] = u(anchor, 0) - u(node, 0);
    for (Eigen::Index k = 1; k < n; ++k) G(i - 1, k - 1) = u(node, k) - u(anchor, k);
  }
  const Eigen::VectorXd flux = n > 1 ? Eigen::VectorXd(G.ldlt().solve(b)) : Eigen::VectorXd(0);
  std::vector<double> fluxes{total - flux.sum()};
  fluxes.insert(fluxes.end(), flux.begin(), flux.end());
  return fluxes;
}

}  // namespace

/// K_asked − K per node for cones and given turning; open loops get nothing.
Eigen::VectorXd curvatureGap(const FilledSurface& surface, const HolonomySpec& spec) {
  Eigen::VectorXd gap(surface.nodeCount);
  for (int n = 0; n < surface.nodeCount; ++n)
    gap[n] = -surface.curvature[static_cast<std::size_t>(n)];
  for (const ConePoint& cone : spec.cones)
    gap[surface.node[cone.vertex]] += coneCurvature(cone.k, spec.q);
  for (std::size_t j = 0; j < surface.loopNode.size(); ++j)
    if (j < spec.turning.size() && spec.turning[j])
      gap[surface.loopNode[j]] += coneCurvature(-*spec.turning[j], spec.q);
  return gap;
}

Result<std::vector<int>> completeTurning(const TriMesh& mesh, const FieldContext& context,
                                         const HolonomySpec& spec) {
  std::vector<int> turning(context.surface.loopNode.size(), 0);
  std::vector<int> open;
  const int m = static_cast<int>(turning.size());
  long long rest = static_cast<long long>(spec.q) * (2 - 2 * context.topology.genus - m);
  for (std::size_t j = 0; j < turning.size(); ++j) {
    if (j < spec.turning.size() && spec.turning[j]) {
      turning[j] = *spec.turning[j];
      rest -= turning[j];
    } else {
      open.push_back(static_cast<int>(j));
    }
  }
  if (open.empty()) return turning;
  for (const ConePoint& cone : spec.cones) rest -= spec.q - cone.k;

  const std::vector<double> fluxes = equalFluxes(context, spec, open);
  std::vector<double> natural(open.size()), lower(open.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    natural[i] = spec.q * (fluxes[i] / (2.0 * kPi) - 1.0);
    lower[i] = 0.0;
    for (HalfedgeId h : context.topology.loops[static_cast<std::size_t>(open[i])].halfedges)
      lower[i] += 0.5 * spec.q * (1 - mesh.valence(mesh.tail(h)));
  }
  const std::vector<int> rounded = roundWithSum(natural, rest, lower);
  if (rounded.empty())
    return Failure{
        ErrorCode::kPrescription,
        "prescription",
        "No admissible turning indices balance Gauss–Bonnet (Lemma 6.2) with these cones: "
        "the open boundary loops would have to take " +
            std::to_string(rest) + " in total, below what their triangles allow.",
        {}};
  for (std::size_t i = 0; i < open.size(); ++i)
    turning[static_cast<std::size_t>(open[i])] = rounded[i];
  return turning;
}

}  // namespace hgp
