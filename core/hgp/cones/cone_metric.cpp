#include "hgp/cones/cone_metric.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {

ConeMetric::ConeMetric(const TriMesh& mesh, const FieldContext& context, int q)
    : mesh_(mesh), context_(context), q_(q), total_(q * (2 - 2 * context.topology.genus)) {
  const FilledSurface& surface = context.surface;
  area_ = Eigen::VectorXd::Zero(surface.nodeCount);
  for (FaceId f : mesh.faces())
    for (VertexId v : mesh.corners(f)) area_[surface.node[v]] += context.geometry.area[f];
  size_ = context.geometry.unit * std::sqrt(area_.sum() / 3.0);
  area_ /= area_.sum();
  const auto& loops = context.handles.loops;
  transport_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(loops.size()));
  for (std::size_t j = 0; j < loops.size(); ++j)
    for (HalfedgeId h : loops[j].crossed)
      transport_[static_cast<Eigen::Index>(j)] += transport(mesh, context.geometry, h);
  if (loops.empty()) return;
  meanPotential_ = context.handles.potential.transpose() * area_;
  rounding_ = NearestLatticePoint(context.handles.periods,
                                  Eigen::VectorXd::Constant(transport_.size(), turnAngle(1, q)));
}

Eigen::VectorXd ConeMetric::centred(Eigen::VectorXd u) const {
  u.array() -= u.dot(area_);
  return u;
}

ConeCost ConeMetric::cost(const NodeDefects& defects) const {
  Eigen::VectorXd gap(nodeCount());
  long long sum = 0;
  for (int n = 0; n < nodeCount(); ++n) {
    const auto at = static_cast<std::size_t>(n);
    gap[n] = turnAngle(defects[at], q_) - context_.surface.curvature[at];
    sum += defects[at];
  }
  gap += turnAngle(static_cast<double>(total_ - sum), q_) * area_;
  gap.array() -= gap.mean();  // removes rounding errors: the sum is 0
  ConeCost cost;
  cost.u = centred(context_.laplacian.solve(gap));
  // Σ over the crossed edges of w du = −(div w ξ⁰)·L⁻¹ gap = −f·gap.
  cost.natural = transport_;
  if (transport_.size() > 0) cost.natural -= context_.handles.potential.transpose() * gap;
  measure(cost);
  return cost;
}

void ConeMetric::measure(ConeCost& cost) const {
  cost.scale = cost.u.cwiseAbs2().dot(area_);
  cost.energy = cost.scale;
  if (cost.natural.size() == 0) return;
  const Eigen::VectorXd offset = rounding_.round(-cost.natural);
  cost.twist = rounding_.solve(offset);
  cost.energy += kTwistWeight * offset.dot(cost.twist);
}

Eigen::VectorXd ConeMetric::scaleGradient(const ConeCost& cost) const {
  Eigen::VectorXd weighted = area_.cwiseProduct(cost.u);
  weighted.array() -= weighted.mean();
  return 2.0 * turnAngle(1, q_) * centred(context_.laplacian.solve(weighted));
}

ConeSlope ConeMetric::slope(const ConeCost& cost) const {
  ConeSlope slope{scaleGradient(cost), {}};
  if (cost.twist.size() == 0) return slope;
  const double factor = 2.0 * turnAngle(1, q_) * kTwistWeight;
  slope.twist = combineForms(mesh_, context_.surface, context_.handles, factor * cost.twist);
  return slope;
}

Eigen::MatrixXd ConeMetric::response(const std::vector<int>& nodes) const {
  return responses(nodes.size(), [&](std::size_t i, auto gap) {
    gap = -area_;
    gap[nodes[i]] += 1.0;
  });
}

Eigen::MatrixXd ConeMetric::moveResponse(const std::vector<UnitMove>& moves) const {
  return responses(moves.size(), [&](std::size_t i, auto gap) {
    gap[moves[i].from] -= moves[i].units;
    gap[moves[i].to] += moves[i].units;
  });
}

/// Block by block, so that beside the result only a block of columns takes memory.
template <class AddGap>
Eigen::MatrixXd ConeMetric::responses(std::size_t count, const AddGap& addGap) const {
  constexpr Eigen::Index kBlock = 16;
  Eigen::MatrixXd G(nodeCount(), static_cast<Eigen::Index>(count));
  for (Eigen::Index first = 0; first < G.cols(); first += kBlock) {
    Eigen::MatrixXd gap = Eigen::MatrixXd::Zero(nodeCount(), std::min(kBlock, G.cols() - first));
    for (Eigen::Index i = 0; i < gap.cols(); ++i)
      addGap(static_cast<std::size_t>(first + i), gap.col(i));
    gap *= turnAngle(1, q_);
    const Eigen::MatrixXd block = context_.laplacian.solve(gap);
    for (Eigen::Index i = 0; i < gap.cols(); ++i) G.col(first + i) = centred(block.col(i));
  }
  return G;
}

Eigen::VectorXd ConeMetric::naturalResponse(int node) const {
  if (transport_.size() == 0) return {};
  return -turnAngle(1, q_) * (context_.handles.potential.row(node).transpose() - meanPotential_);
}

int coneCount(const TriMesh& mesh, const FieldContext& context, const NodeDefects& defects) {
  int count = 0;
  for (VertexId v : mesh.vertices())
    if (context.surface.isInterior(mesh, v))
      count += defects[static_cast<std::size_t>(context.surface.node[v])] != 0;
  return count;
}

double areaSpread(double scale) { return 2.0 / portable::log(2.0) * std::sqrt(scale); }

}  // namespace hgp
