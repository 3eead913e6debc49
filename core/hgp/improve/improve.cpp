#include "hgp/improve/improve.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/improve/best_scale.h"
#include "hgp/improve/newton_system.h"
#include "hgp/verify/orientation.h"

namespace hgp {
namespace {

/// Maximum step as a fraction of the step at which the first triangle degenerates.
constexpr double kDegeneracyShare = 0.8;
/// Armijo's condition, and the step length below which the descent ends.
constexpr double kSufficientDecrease = 1e-4;
constexpr double kShortestStep = 1e-8;
/// The energy with the knee is used once a step lowers the one without by less than this fraction: with the knee, bad
/// triangles would stay bad and limit the step lengths.
constexpr double kOpened = 0.1;
/// Below this excess a map is an isometry up to rounding.
constexpr double kNoExcess = 1e-12;

/// Whether every triangle of z = copies · x is positive, exactly.
bool isInjective(const ReducedMap& map, const Eigen::VectorXcd& x) {
  const Eigen::VectorXcd z = map.unknowns.copies * x;
  const auto corner = [&](FaceId f, int k) {
    const Complex& p = z[map.cut.copy[TriMesh::halfedge(f, k)].i];
    return Vec2{p.real(), p.imag()};
  };
  for (FaceId f : map.mesh.faces())
    if (orientationSign(corner(f, 0), corner(f, 1), corner(f, 2)) <= 0) return false;
  return true;
}

/// The state of one descent.
class Descent {
 public:
  Descent(const ReducedMap& map, const linalg::SeparatorTree& tree, const Eigen::VectorXcd& x,
          double balance, const std::vector<char>& isHeld)
      : map_(map),
        asked_(exponentsAt(balance)),
        exponents_(asked_),
        terms_(map, isHeld, x),
        system_(map, terms_, tree),
        x_(x),
        free_(terms_.free().gather(x)) {
    evaluateParts(terms_, free_, false, parts_);
    trial_ = parts_;
    measure();
  }

  double excess() const { return energy_ - 1.0; }
  double stepMultiplyAdds() const { return system_.multiplyAdds(); }
  const Eigen::VectorXcd& x() const { return x_; }

  bool hasKnee() const { return asked_.knee != EnergyExponents::kNoKnee; }
  /// Switches to the energy with the knee, or without it.
  void bend(bool isBent) {
    exponents_.knee = isBent ? asked_.knee : EnergyExponents::kNoKnee;
    measure();
  }

  /// False when the Hessian cannot be factored.
  bool assemble() { return system_.assemble(exponents_, parts_, scale_); }

  /// One step along the Newton direction of the last assembly. Returns its length, 0 if the energy does not decrease.
  double descend() {
    const auto [direction, slope] = system_.direction();
    if (!direction.allFinite() || !(slope < 0.0)) return 0.0;
    evaluateParts(terms_, direction, true, change_);
    double length = std::min(1.0, kDegeneracyShare * stepToDegeneracy(parts_, change_, 2.0));
    for (; length > kShortestStep; length *= 0.5) {
      for (std::size_t f = 0; f < parts_.similar.size(); ++f) {
        trial_.similar[f] = parts_.similar[f] + length * change_.similar[f];
        trial_.anti[f] = parts_.anti[f] + length * change_.anti[f];
      }
      const double value = meanEnergy(exponents_, terms_, trial_, scale_);
      if (!(value <= energy_ + kSufficientDecrease * length * slope)) continue;
      Eigen::VectorXcd moved = x_;
      terms_.free().scatter(free_ + length * direction, moved);
      if (!isInjective(map_, moved)) continue;
      x_ = std::move(moved);
      free_ += length * direction;
      evaluateParts(terms_, free_, false, parts_);
      measure();
      return length;
    }
    return 0.0;
  }

 private:
  void measure() {
    scale_ = bestScale(exponents_, terms_, parts_, scale_);
    energy_ = meanEnergy(exponents_, terms_, parts_, scale_);
  }

  const ReducedMap& map_;
  const EnergyExponents asked_;
  EnergyExponents exponents_;  ///< those of this part of the descent
  FaceTerms terms_;
  NewtonSystem system_;
  Eigen::VectorXcd x_, free_;
  FaceParts parts_, change_, trial_;
  double scale_ = 1.0, energy_ = 0.0;
};

/// Takes steps until the descent ends, and returns why.
DescentOutcome run(Descent& descent, const ImproveOptions& options, const Progress& progress,
                   std::vector<ImproveStep>& steps, double& multiplyAdds) {
  if (!std::isfinite(descent.excess())) return DescentOutcome::kNotInjective;
  bool isBent = !descent.hasKnee();
  descent.bend(isBent);
  for (int n = 0; n < options.maxSteps; ++n) {
    const double excess = descent.excess();
    const double fraction = static_cast<double>(n) / options.maxSteps;
    if (!report(progress, {Stage::kImprove, fraction, n, excess}))
      return DescentOutcome::kCancelled;
    if (excess <= kNoExcess) return DescentOutcome::kNothingToGain;
    if (multiplyAdds + descent.stepMultiplyAdds() > options.maxMultiplyAdds)
      return DescentOutcome::kWorkLimit;
    multiplyAdds += descent.stepMultiplyAdds();
    if (!descent.assemble()) return DescentOutcome::kSingular;
    const double length = descent.descend();
    if (length <= 0.0) return DescentOutcome::kNoDescent;
    steps.push_back({descent.excess(), length});
    const double decrease = 1.0 - descent.excess() / excess;
    if (decrease <= options.relativeDecrease && isBent) return DescentOutcome::kConverged;
    if (decrease <= kOpened && !isBent) descent.bend(isBent = true);
  }
  return DescentOutcome::kStepLimit;
}

}  // namespace

const char* outcomeName(DescentOutcome outcome) {
  switch (outcome) {
    case DescentOutcome::kConverged:
      return "converged";
    case DescentOutcome::kNothingToGain:
      return "nothing to gain";
    case DescentOutcome::kNoDescent:
      return "no descent";
    case DescentOutcome::kStepLimit:
      return "step limit";
    case DescentOutcome::kWorkLimit:
      return "work limit";
    case DescentOutcome::kSingular:
      return "singular";
    case DescentOutcome::kNotInjective:
      return "not injective";
    case DescentOutcome::kCancelled:
      return "cancelled";
  }
  return "";
}

Improvement improve(const ReducedMap& map, const linalg::SeparatorTree& tree,
                    const Eigen::VectorXcd& x, const ImproveOptions& options,
                    const std::vector<char>& isHeld, const Progress& progress) {
  HGP_CHECK(x.size() == map.unknowns.copies.cols(), "%d values for %d unknowns",
            static_cast<int>(x.size()), static_cast<int>(map.unknowns.copies.cols()));
  Improvement result;
  result.x = x;
  if (!isInjective(map, x)) {
    result.outcome = DescentOutcome::kNotInjective;
    return result;
  }
  std::vector<char> held = isHeld;
  held.resize(at(x.size()), 0);
  Descent descent(map, tree, x, options.balance, held);
  result.excessBefore = descent.excess();
  result.outcome = run(descent, options, progress, result.steps, result.multiplyAdds);
  descent.bend(descent.hasKnee());
  result.excessAfter = descent.excess();
  if (result.excessAfter < result.excessBefore) {
    result.x = descent.x();
  } else {
    result.excessAfter = result.excessBefore;
  }
  return result;
}

}  // namespace hgp
