#include "hgp/socp/solve.h"

#include <algorithm>
#include <cmath>

#include "hgp/socp/second_order_cone.h"

namespace hgp::socp {

const char* statusName(SolveStatus status) {
  switch (status) {
    case SolveStatus::kOptimal:
      return "optimal";
    case SolveStatus::kAlmost:
      return "almost";
    case SolveStatus::kInfeasible:
      return "infeasible";
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

using Slacks = std::vector<Vector3>;

/// F_b x
Vector3 image(const ConeConstraint& constraint, const Eigen::VectorXd& x) {
  Vector3 r = Vector3::Zero();
  for (std::size_t i = 0; i < constraint.unknowns.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(2 * i);
    r += constraint.F.middleCols<2>(column) * x.segment<2>(2 * constraint.unknowns[i]);
  }
  return r;
}

/// Share of the way to the cone's boundary that a step may go.
constexpr double kStepToBoundary = 0.99;
/// A residual within this factor of its target is reported "almost".
constexpr double kAlmostFactor = 100.0;
/// A start that misses a cone by this many times |h| is drawn closer to all of them first.
constexpr double kFarOutside = 30.0;
constexpr double kTinyStep = 1e-6;
/// |Fᵀy| against hᵀy below which y proves infeasibility, and the weaker bound after a stall.
constexpr double kCertificateShare = 1e-8;
constexpr double kStalledCertificateShare = 1e-3;

class InteriorPoint {
 public:
  InteriorPoint(const Problem& problem, const SolveOptions& options)
      : p_(problem), o_(options), count_(problem.constraints.size()) {
    for (const ConeConstraint& b : p_.constraints) scaleH_ = std::max(scaleH_, b.h.norm());
    if (scaleH_ == 0.0) scaleH_ = 1.0;
  }

  Solution run() {
    Solution result;
    if (!start()) return finish(result, SolveStatus::kStalled);
    for (int k = 0; k < o_.maxIterations; ++k) {
      result.iterations = k;
      computeResiduals();
      remember();
      if (o_.progress && !o_.progress(k, measure())) return finish(result, SolveStatus::kCancelled);
      if (measure() <= 1.0) return finish(result, SolveStatus::kOptimal);
      if (isInfeasible(k)) return finish(result, SolveStatus::kInfeasible);
      if (!factorScaled()) return finish(result, SolveStatus::kStalled);

      // Predictor: straight at the solution; how far it gets decides the centring.
      Slacks target(count_);
      for (std::size_t b = 0; b < count_; ++b)
        target[b] = -product(scaling_[b].lambda, scaling_[b].lambda);
      const Step affine = solveStep(target, 1.0);
      const double reach = stepAlong(affine, 1.0);
      const double sigma = std::pow(1.0 - reach, 3);

      // Corrector: second-order term and centring.
      for (std::size_t b = 0; b < count_; ++b) {
        target[b] -= product(scaling_[b].inverse * affine.s[b], scaling_[b].W * affine.y[b]);
        target[b][0] += sigma * mu_;
      }
      const Step step = solveStep(target, 1.0 - sigma);
      const double alpha = std::min(1.0, stepAlong(step, kStepToBoundary));
      if (!(alpha > kTinyStep) || !step.x.allFinite()) return finish(result, SolveStatus::kStalled);
      x_ += alpha * step.x;
      for (std::size_t b = 0; b < count_; ++b) {
        s_[b] += alpha * step.s[b];
        y_[b] += alpha * step.y[b];
      }
    }
    result.iterations = o_.maxIterations;
    computeResiduals();
    remember();
    return finish(result, SolveStatus::kIterationLimit);
  }

 private:
  struct Step {
    Eigen::VectorXd x;
    Slacks s, y;
  };

  Vector3 apply(std::size_t b, const Eigen::VectorXd& x) const {
    return image(p_.constraints[b], x);
  }
  /// out += factor · F_bᵀ v
  void addTransposed(std::size_t b, const Vector3& v, double factor, Eigen::VectorXd& out) const {
    const ConeConstraint& constraint = p_.constraints[b];
    for (std::size_t i = 0; i < constraint.unknowns.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(2 * i);
      out.segment<2>(2 * constraint.unknowns[i]) +=
          factor * constraint.F.middleCols<2>(column).transpose() * v;
    }
  }

  /// Factors H + Σ Fᵀ M_b F with the given 3 × 3 metrics.
  template <class MetricOf>
  bool factorWith(const MetricOf& metricOf) {
    values_.resize(p_.form->blockStorage());
    for (std::size_t b = 0; b < count_; ++b) {
      const auto& F = p_.constraints[b].F;
      Eigen::Map<Eigen::MatrixXd> block(values_.data() + p_.form->blockOffset(static_cast<int>(b)),
                                        F.cols(), F.cols());
      block.noalias() = F.transpose() * metricOf(b) * F;
    }
    return static_cast<bool>(p_.form->factor(values_.data()));
  }
  bool factorScaled() {
    scaling_.resize(count_);
    for (std::size_t b = 0; b < count_; ++b) {
      scaling_[b] = ntScaling(s_[b], y_[b]);
      if (!scaling_[b].inverse.allFinite()) return false;
    }
    return factorWith(
        [&](std::size_t b) -> Matrix3 { return scaling_[b].inverse * scaling_[b].inverse; });
  }

  /// The minimiser without constraints, if it fulfils them all: then it is the solution.
  bool startUnconstrained() {
    if (count_ == 0 || !factorWith([](std::size_t) -> Matrix3 { return Matrix3::Zero(); }))
      return false;
    x_ = p_.form->solve(Eigen::VectorXd(-p_.c));
    if (!x_.allFinite()) return false;
    s_.resize(count_);
    bool isInside = true;
    double squares = 0.0;
    for (std::size_t b = 0; b < count_; ++b) {
      s_[b] = apply(b, x_);
      squares += s_[b].squaredNorm();
      s_[b] -= p_.constraints[b].h;
      isInside = isInside && depth(s_[b]) >= 0.0;
    }
    const double stiffness = x_.dot(p_.form->apply(x_)) / squares;
    if (std::isfinite(stiffness) && stiffness > 0.0) stiffness_ = stiffness;
    if (!isInside) return false;
    y_.assign(count_, Vector3::Zero());
    computeResiduals();
    firstGap_ = -1.0;
    isFree_ = measure() <= 1.0;
    return isFree_;
  }

  /// The minimiser of the objective + ½ρ|F x − h|², with s and y = −ρs pushed into the cone. Returns
  /// how far s had to be pushed.
  double startWith(double rho) {
    Eigen::VectorXd rhs = -p_.c;
    for (std::size_t b = 0; b < count_; ++b) addTransposed(b, p_.constraints[b].h, rho, rhs);
    x_ = Eigen::VectorXd::Zero(p_.c.size());
    const bool isFactored =
        factorWith([rho](std::size_t) -> Matrix3 { return rho * Matrix3::Identity(); });
    if (isFactored) x_ = p_.form->solve(rhs);
    if (!x_.allFinite()) x_.setZero();
    s_.resize(count_);
    y_.resize(count_);
    double needS = 0.0, needY = 0.0;
    for (std::size_t b = 0; b < count_; ++b) {
      s_[b] = apply(b, x_) - p_.constraints[b].h;
      y_[b] = -rho * s_[b];
      needS = std::max(needS, -depth(s_[b]));
      needY = std::max(needY, -depth(y_[b]));
    }
    for (std::size_t b = 0; b < count_; ++b) {
      s_[b][0] += needS + scaleH_;
      y_[b][0] += needY + rho * scaleH_;
    }
    return needS;
  }

  bool start() {
    if (startUnconstrained()) return true;
    // ρ is what the objective itself resists a change of F x with, xᵀHx / |F x|² at the minimiser
    // without constraints: s and y start at their own scales. Where that minimiser is far outside
    // the cones, its scale says little.
    double rho = std::clamp(stiffness_, 1e-8, 1.0);
    while (startWith(rho) > kFarOutside * scaleH_ && rho < 1.0) rho = std::min(1.0, 100.0 * rho);
    return true;
  }

  void computeResiduals() {
    const Eigen::VectorXd Hx = p_.form->apply(x_);
    rx_ = Hx + p_.c;
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(rx_.size());
    rs_.resize(count_);
    primal_ = 0.0;
    double gap = 0.0;
    for (std::size_t b = 0; b < count_; ++b) {
      addTransposed(b, y_[b], -1.0, pull);
      rs_[b] = s_[b] - apply(b, x_) + p_.constraints[b].h;
      primal_ = std::max(primal_, rs_[b].norm() / scaleH_);
      gap += s_[b].dot(y_[b]);
    }
    const double scale = std::max({Hx.norm(), p_.c.norm(), pull.norm(), 1e-300});
    rx_ += pull;
    dual_ = rx_.norm() / scale;
    mu_ = count_ ? gap / static_cast<double>(count_) : 0.0;
    const double objective = 0.5 * x_.dot(Hx) + p_.c.dot(x_);
    if (firstGap_ < 0.0) firstGap_ = gap;
    // The objective may be exactly zero (a q-CCM exists): then the gap counts against its start.
    gap_ = gap / std::max({std::abs(objective), 1e-3 * firstGap_, 1e-300});
  }
  double measure() const { return std::max({primal_ / o_.primal, dual_ / o_.dual, gap_ / o_.gap}); }

  /// Farkas: y in the cone with Fᵀy = 0 and hᵀy > 0 proves that no x has F x − h in the cone. Judged
  /// by size, since y only tends to such a direction.
  bool isCertificate(double share) const {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(x_.size());
    double gain = 0.0, size = 0.0;
    for (std::size_t b = 0; b < count_; ++b) {
      addTransposed(b, y_[b], 1.0, pull);
      gain += p_.constraints[b].h.dot(y_[b]);
      size += scaleH_ * y_[b].norm();
    }
    return gain > share * size && scaleH_ * pull.norm() <= share * gain;
  }

  /// The primal residual sticks while the duals run away.
  bool isInfeasible(int k) {
    history_.push_back(primal_);
    if (primal_ <= o_.primal * kAlmostFactor) return false;
    if (k >= 16 && primal_ > 0.96 * history_[history_.size() - 7]) return true;
    return isCertificate(kCertificateShare);
  }

  /// rhs of the scaled complementarity is `target`; residuals are reduced by `share`.
  Step solveStep(const Slacks& target, double share) {
    Step step;
    Eigen::VectorXd rhs = -share * rx_;
    Slacks shift(count_);
    for (std::size_t b = 0; b < count_; ++b) {
      // W⁻ᵀds + W dy = λ⋄target and ds = F dx − share·r_s give
      // dy = W⁻²(W(λ⋄target) + share·r_s − F dx).
      const Matrix3& inverse = scaling_[b].inverse;
      shift[b] = inverse * (divide(scaling_[b].lambda, target[b]) + inverse * (share * rs_[b]));
      addTransposed(b, shift[b], 1.0, rhs);
    }
    step.x = p_.form->solve(rhs);
    step.s.resize(count_);
    step.y.resize(count_);
    for (std::size_t b = 0; b < count_; ++b) {
      const Vector3 moved = apply(b, step.x);
      step.s[b] = moved - share * rs_[b];
      step.y[b] = shift[b] - scaling_[b].inverse * (scaling_[b].inverse * moved);
    }
    return step;
  }

  double stepAlong(const Step& step, double share) const {
    double alpha = 1.0 / share;
    for (std::size_t b = 0; b < count_; ++b) {
      alpha = std::min(alpha, stepLength(s_[b], step.s[b] * alpha) * alpha);
      alpha = std::min(alpha, stepLength(y_[b], step.y[b] * alpha) * alpha);
    }
    return share * alpha;
  }

  void remember() {
    if (!x_.allFinite() || (best_.size() && measure() > bestMeasure_)) return;
    bestMeasure_ = measure();
    best_ = x_;
    bestResiduals_[0] = primal_;
    bestResiduals_[1] = dual_;
    bestResiduals_[2] = gap_;
  }

  Solution& finish(Solution& result, SolveStatus status) {
    result.x = best_.size() ? best_ : x_;
    result.y = y_;
    result.isFree = isFree_;
    result.primalResidual = bestResiduals_[0];
    result.dualResidual = bestResiduals_[1];
    result.gap = bestResiduals_[2];
    if (status == SolveStatus::kStalled && primal_ > o_.primal * kAlmostFactor && !y_.empty() &&
        isCertificate(kStalledCertificateShare))
      status = SolveStatus::kInfeasible;
    const bool isClose = best_.size() && bestMeasure_ <= kAlmostFactor;
    const bool isCutShort =
        status == SolveStatus::kStalled || status == SolveStatus::kIterationLimit;
    result.status = isCutShort && isClose ? SolveStatus::kAlmost : status;
    return result;
  }

  const Problem& p_;
  const SolveOptions& o_;
  std::size_t count_;
  Eigen::VectorXd x_, rx_, best_;
  Slacks s_, y_, rs_;
  std::vector<Scaling> scaling_;
  std::vector<double> values_, history_;
  bool isFree_ = false;
  double scaleH_ = 0.0, stiffness_ = 1.0, mu_ = 0.0, firstGap_ = -1.0;
  double primal_ = 0.0, dual_ = 0.0, gap_ = 0.0;
  double bestMeasure_ = 0.0, bestResiduals_[3] = {0.0, 0.0, 0.0};
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
