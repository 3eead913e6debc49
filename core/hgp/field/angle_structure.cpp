#include "hgp/field/angle_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/portable_math.h"
#include "hgp/field/surface_laplacian.h"

namespace hgp {
namespace {

/// Smaller angles of the surface, in radians, are replaced by this one.
constexpr double kMinOwnAngle = 0.02;
/// Tolerance of the angle sums, in radians.
constexpr double kMetSum = 1e-9;
/// Smaller angles show that the prescription has no angle structure: the iteration then diverges to infinity.
constexpr double kMinAngle = 1e-8;
/// Newton takes 4 to 10 steps where there is a structure.
constexpr int kMaxSteps = 60;
constexpr double kMinStep = 1e-6;
constexpr double kSufficientDecrease = 1e-4;
/// Rounding of the function, relative to its value.
constexpr double kRounding = 1e-13;

Eigen::VectorXd askedSums(const FieldContext& context, const CompleteSpec& spec) {
  const FilledSurface& surface = context.surface;
  Eigen::VectorXd asked = Eigen::VectorXd::Constant(surface.nodeCount, 2.0 * kPi);
  for (const ConePoint& cone : spec.cones)
    asked[surface.node[cone.vertex]] = turnAngle(cone.k, spec.q);
  for (std::size_t i = 0; i < surface.loopNode.size(); ++i)
    asked[surface.loopNode[i]] =
        kPi * static_cast<double>(context.topology.loops[i].halfedges.size()) -
        turnAngle(spec.turning[i], spec.q);
  return asked;
}

class DualFunction {
 public:
  DualFunction(const TriMesh& mesh, const FieldContext& context)
      : mesh_(mesh),
        context_(context),
        own_(static_cast<std::size_t>(mesh.halfedgeCount()), 0.0),
        angle_(own_) {
    for (HalfedgeId h : mesh.halfedges())
      own_[h] = portable::log(std::max(context.geometry.cornerAngle[h], kMinOwnAngle));
  }

  const PerHalfedge<double>& angles() const { return angle_; }
  /// Sum of the angles, per node.
  const Eigen::VectorXd& sums() const { return sum_; }

  /// Returns Σ_f π log Σ_f α e^{s}; sets angles and sums.
  double evaluate(const Eigen::VectorXd& s) {
    double value = 0.0;
    sum_ = Eigen::VectorXd::Zero(s.size());
    for (FaceId f : mesh_.faces()) {
      std::array<double, 3> power{};
      for (std::size_t k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, static_cast<int>(k));
        power[k] = own_[h] + s[nodeOf(h)];
      }
      const double highest = *std::max_element(power.begin(), power.end());
      double total = 0.0;
      for (double& p : power) total += p = portable::exp(p - highest);
      value += kPi * (portable::log(total) + highest);
      for (std::size_t k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, static_cast<int>(k));
        angle_[h] = kPi * power[k] / total;
        sum_[nodeOf(h)] += angle_[h];
      }
    }
    return value;
  }

  /// (Hessian)⁻¹ gap, up to a constant.
  std::optional<Eigen::VectorXd> newtonStep(const Eigen::VectorXd& gap) const {
    FilledSurface weighted = context_.surface;
    for (double& w : weighted.weight.raw()) w = 0.0;
    for (HalfedgeId h : mesh_.halfedges())
      if (!mesh_.isBoundary(h))
        weighted.weight[mesh_.edge(h)] += angle_[h] * angle_[TriMesh::next(h)] / kPi;
    const Result<SurfaceLaplacian> hessian =
        SurfaceLaplacian::build(mesh_, weighted, context_.tree);
    if (!hessian) return {};
    const Eigen::VectorXd balanced = gap.array() - gap.mean();
    Eigen::VectorXd step = hessian->solve(balanced).col(0);
    if (!step.allFinite()) return {};
    return step;
  }

 private:
  int nodeOf(HalfedgeId h) const { return context_.surface.node[mesh_.tail(h)]; }

  const TriMesh& mesh_;
  const FieldContext& context_;
  PerHalfedge<double> own_;  ///< log α
  PerHalfedge<double> angle_;
  Eigen::VectorXd sum_;
};

/// Minimises the dual function; whether the angle sums are then as asked.
bool minimise(DualFunction& dual, const Eigen::VectorXd& asked) {
  Eigen::VectorXd s = Eigen::VectorXd::Zero(asked.size());
  double value = dual.evaluate(s) - asked.dot(s);
  for (int step = 0; step < kMaxSteps; ++step) {
    const Eigen::VectorXd gap = asked - dual.sums();
    if (gap.cwiseAbs().maxCoeff() < kMetSum) return true;
    const std::optional<Eigen::VectorXd> direction = dual.newtonStep(gap);
    if (!direction) return false;
    const double slope = gap.dot(*direction), rounding = kRounding * std::abs(value);
    double t = 1.0, moved = 0.0;
    for (; t > kMinStep; t *= 0.5) {
      const Eigen::VectorXd there = s + t * *direction;
      moved = dual.evaluate(there) - asked.dot(there);
      if (moved <= value - kSufficientDecrease * t * slope + rounding) break;
    }
    if (t <= kMinStep) return false;
    s += t * *direction;
    value = moved;
  }
  return false;
}

}  // namespace

std::optional<PerHalfedge<double>> angleStructure(const TriMesh& mesh, const FieldContext& context,
                                                  const CompleteSpec& spec) {
  DualFunction dual(mesh, context);
  if (!minimise(dual, askedSums(context, spec))) return {};
  const std::vector<double>& angles = dual.angles().raw();
  if (*std::min_element(angles.begin(), angles.end()) < kMinAngle) return {};
  return dual.angles();
}

}  // namespace hgp
