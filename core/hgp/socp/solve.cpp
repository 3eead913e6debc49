#include "hgp/socp/solve.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/socp/start.h"

namespace hgp::socp {

const char* statusName(SolveStatus status) {
  switch (status) {
    case SolveStatus::kOptimal:
      return "optimal";
    case SolveStatus::kAlmost:
      return "almost";
    case SolveStatus::kInfeasible:
      return "infeasible";
    case SolveStatus::kNoProgress:
      return "no-progress";
    case SolveStatus::kStalled:
      return "stalled";
    case SolveStatus::kIterationLimit:
      return "iteration-limit";
    case SolveStatus::kCancelled:
      return "cancelled";
  }
  return "stalled";
}

namespace {

/// Maximum step as a fraction of the distance to the cone's boundary.
constexpr double kStepToBoundary = 0.99;
/// A residual within this factor of its target is reported "almost".
constexpr double kAlmostFactor = 100.0;
constexpr double kTinyStep = 1e-6;
/// |Fᵀy| against hᵀy below which y proves infeasibility, and the bound below which it only suggests it: then
/// a stall is not called one near a solution.
constexpr double kCertificateShare = 1e-8;
constexpr double kSuggestedShare = 1e-3;
/// Constraints whose duals are at least this fraction of the largest are tried as such a proof, the fewest first.
constexpr double kSupports[] = {0.1, 1e-3, 1e-6, 0.0};
/// The primal residual has stalled when it fell by less than this in this many iterations, not counting the first ones.
constexpr int kSettled = 16, kLookBack = 6;
constexpr double kStuck = 0.96;

/// The largest step length α ≤ 1 that is at most this fraction of the step to the cones' boundaries.
double reach(const Iterate& point, const Iterate& step, double share) {
  double alpha = 1.0 / share;
  for (std::size_t b = 0; b < point.s.size(); ++b) {
    alpha = std::min(alpha, stepLength(point.s[b], step.s[b] * alpha) * alpha);
    alpha = std::min(alpha, stepLength(point.y[b], step.y[b] * alpha) * alpha);
  }
  return share * alpha;
}

class InteriorPoint {
 public:
  InteriorPoint(const Problem& problem, const SolveOptions& options)
      : p_(problem), o_(options), system_(problem), scaleH_(offsetScale(problem)) {}

  Solution run() {
    Start start = startingPoint(p_, o_, system_);
    point_ = std::move(start.point);
    isFree_ = start.isFree;
    for (int k = 0; k < o_.maxIterations; ++k) {
      iterations_ = k;
      look();
      if (o_.progress && !o_.progress(k, measure_)) return finish(SolveStatus::kCancelled);
      if (measure_ <= 1.0) return finish(SolveStatus::kOptimal);
      if (isFar() && provesInfeasible(p_, point_.y, scaleH_, kCertificateShare))
        return finish(SolveStatus::kInfeasible);
      if (isFar() && isStuck(k)) return finish(stuck());
      if (!system_.factorScaled(point_)) return finish(SolveStatus::kStalled);

      // Predictor: the affine scaling step; its length determines the centring.
      Slacks target = system_.predictorTarget();
      const Iterate affine = system_.step(target, residuals_, 1.0);
      const double sigma = portable::pow(1.0 - reach(point_, affine, 1.0), 3);

      // Corrector: second-order term and centring.
      system_.correct(target, affine, sigma * residuals_.mu);
      const Iterate step = system_.step(target, residuals_, 1.0 - sigma);
      const double alpha = std::min(1.0, reach(point_, step, kStepToBoundary));
      if (!(alpha > kTinyStep) || !step.x.allFinite()) return finish(SolveStatus::kStalled);
      point_.x += alpha * step.x;
      for (std::size_t b = 0; b < point_.s.size(); ++b) {
        point_.s[b] += alpha * step.s[b];
        point_.y[b] += alpha * step.y[b];
      }
    }
    iterations_ = o_.maxIterations;
    look();
    return finish(SolveStatus::kIterationLimit);
  }

 private:
  /// Measures the current point and stores it if it is the best so far.
  void look() {
    residuals_ = residualsAt(p_, point_, scaleH_);
    history_.push_back(residuals_.primal);
    if (firstComplement_ < 0.0) firstComplement_ = residuals_.complement;
    // The objective may be exactly zero (a q-CCM exists), so the gap is also compared with its initial value.
    gap_ = residuals_.complement /
           std::max({std::abs(residuals_.objective), 1e-3 * firstComplement_, 1e-300});
    measure_ = std::max({residuals_.primal / o_.primal, residuals_.dual / o_.dual, gap_ / o_.gap});
    if (!point_.x.allFinite() || (best_.x.size() && measure_ > bestMeasure_)) return;
    bestMeasure_ = measure_;
    best_.x = point_.x;
    best_.primalResidual = residuals_.primal;
    best_.dualResidual = residuals_.dual;
    best_.gap = gap_;
  }

  bool isFar() const { return residuals_.primal > o_.primal * kAlmostFactor; }
  /// The primal residual has not fallen for some iterations.
  bool isStuck(int k) const {
    return k >= kSettled && residuals_.primal > kStuck * history_[history_.size() - 1 - kLookBack];
  }

  /// Why: the constraints contradict each other, if the duals of some of them, projected onto Fᵀy = 0, prove it.
  SolveStatus stuck() {
    double largest = 0.0;
    for (const Vector3& v : point_.y) largest = std::max(largest, v.norm());
    for (const double share : kSupports) {
      Slacks y = point_.y;
      for (Vector3& v : y)
        if (v.norm() < share * largest) v.setZero();
      y = withoutPull(p_, std::move(y));
      for (Vector3& v : y) v[0] += std::max(0.0, -depth(v));
      if (!provesInfeasible(p_, y, scaleH_, kCertificateShare)) continue;
      point_.y = std::move(y);
      return SolveStatus::kInfeasible;
    }
    return SolveStatus::kNoProgress;
  }

  Solution finish(SolveStatus status) {
    Solution result = best_;
    const bool isKnown = best_.x.size() > 0;
    if (!isKnown) result.x = point_.x;
    if (status == SolveStatus::kStalled && isFar() && !point_.y.empty() &&
        provesInfeasible(p_, point_.y, scaleH_, kSuggestedShare))
      status = stuck();
    result.y = point_.y;
    result.isFree = isFree_;
    result.iterations = iterations_;
    const bool isCutShort =
        status == SolveStatus::kStalled || status == SolveStatus::kIterationLimit;
    const bool isClose = isKnown && bestMeasure_ <= kAlmostFactor;
    result.status = isCutShort && isClose ? SolveStatus::kAlmost : status;
    return result;
  }

  const Problem& p_;
  const SolveOptions& o_;
  NewtonSystem system_;
  const double scaleH_;
  Iterate point_;
  Residuals residuals_;
  double gap_ = 0.0, measure_ = 0.0, firstComplement_ = -1.0, bestMeasure_ = 0.0;
  Solution best_;  ///< its x and residuals only
  std::vector<double> history_;
  int iterations_ = 0;
  bool isFree_ = false;
};

}  // namespace

bool isFulfilled(const Problem& problem, const Eigen::VectorXd& x) {
  return std::all_of(
      problem.constraints.begin(), problem.constraints.end(),
      [&](const ConeConstraint& b) { return depth(Vector3(image(b, x) - b.h)) >= 0.0; });
}

Solution solve(const Problem& problem, const SolveOptions& options) {
  return InteriorPoint(problem, options).run();
}

}  // namespace hgp::socp
