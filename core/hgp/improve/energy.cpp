#include "hgp/improve/energy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// Eigenvalues are raised to at least this fraction of the largest, so that the system is regular although rotating and
/// scaling the whole map do not change the energy.
constexpr double kSmallestCurvature = 1e-5;
/// Minimum values of the exponents at the two ends of the family.
constexpr double kAreaFloor = 1e-3;
constexpr double kAngleFloor = 0.05;
/// The knee at balance −1, at |μ| = 0.02, and how fast it grows away from there.
constexpr double kKnee = 2.0 * 0.02 * 0.02;
constexpr double kKneePower = -8.0;

/// log ψ and its derivatives in s = |p|² and t = |m|².
struct LogEnergy {
  double value, s, t, ss, st, tt;
};

LogEnergy logEnergy(const EnergyExponents& e, double s, double t, double d) {
  const double sum = s + t, inverse = 1.0 / d;
  // log D and its derivatives in d, written so that neither end overflows.
  const double big = std::max(d, inverse), small2 = 1.0 / (big * big);
  const double logD = portable::log(0.5 * big) + portable::log1p(small2);
  const double sign = d >= 1.0 ? 1.0 : -1.0;
  const double slope = sign * (1.0 - small2) / (1.0 + small2) * inverse;
  // (−d⁴ + 4d² + 1)/(d³ + d)² = (−1 + 4/d² + 1/d⁴)/(d² (1 + 1/d²)²), which does not overflow for large d.
  const double numerator =
      d >= 1.0 ? -1.0 + small2 * (4.0 + small2) : 1.0 + small2 * (4.0 - small2);
  const double bend = numerator / ((1.0 + small2) * (1.0 + small2)) * inverse * inverse;
  const double a = e.angle, b = e.area;
  LogEnergy log;
  log.value = a * (portable::log(sum) - portable::log(d)) + b * logD;
  log.s = a * (1.0 / sum - inverse) + b * slope;
  log.t = a * (1.0 / sum + inverse) - b * slope;
  log.ss = log.tt = a * (inverse * inverse - 1.0 / (sum * sum)) + b * bend;
  log.st = -a * (inverse * inverse + 1.0 / (sum * sum)) - b * bend;
  return log;
}

/// 1 + φ(ψ − 1).
double bent(const EnergyExponents& e, double psi) {
  if (e.knee == EnergyExponents::kNoKnee) return psi;
  const double k = std::max(0.0, psi - 1.0);
  return 1.0 + 2.0 * k / (1.0 + std::sqrt(1.0 + k / e.knee));
}

/// |z|; faster than std::abs, which guards against overflow that cannot occur at this scale.
double length(const Complex& z) { return std::sqrt(std::norm(z)); }

/// |p|² − |m|², with as little cancellation as |p| and |m| allow.
double determinant(double absP, double absM) { return (absP - absM) * (absP + absM); }

}  // namespace

EnergyExponents exponentsAt(double balance) {
  const double to = std::clamp(balance, -1.0, 1.0);
  return {std::max(kAngleFloor, std::min(1.0, 1.0 - to)),
          std::max(kAreaFloor, std::min(1.0, 1.0 + to)),
          to < 0.0 ? kKnee * portable::pow(-to, kKneePower) : EnergyExponents::kNoKnee};
}

double kneeSlope(const EnergyExponents& e, double psi) {
  if (e.knee == EnergyExponents::kNoKnee) return 1.0;
  return 1.0 / std::sqrt(1.0 + std::max(0.0, psi - 1.0) / e.knee);
}

double energy(const EnergyExponents& e, const Complex& p, const Complex& m) {
  const double absP = length(p), absM = length(m), d = determinant(absP, absM);
  if (!(d > 0.0) || !std::isfinite(d)) return std::numeric_limits<double>::infinity();
  const double K = (absP * absP + absM * absM) / d, D = 0.5 * (d + 1.0 / d);
  if (e.angle == 1.0 && e.area == 1.0) return bent(e, K * D);
  return bent(e, portable::pow(K, e.angle) * portable::pow(D, e.area));
}

EnergyJet energyJet(const EnergyExponents& exponents, const Complex& p, const Complex& m) {
  const double absP = length(p), absM = length(m), s = absP * absP, t = absM * absM;
  const LogEnergy log = logEnergy(exponents, s, t, determinant(absP, absM));
  EnergyJet jet;
  jet.value = portable::exp(log.value);
  const double ps = jet.value * log.s, pt = jet.value * log.t;
  const double pss = jet.value * (log.ss + log.s * log.s);
  const double ptt = jet.value * (log.tt + log.t * log.t);
  const double pst = jet.value * (log.st + log.s * log.t);
  jet.gradientP = 2.0 * ps * p;
  jet.gradientM = 2.0 * pt * m;

  const Complex unitP = p / absP, unitM = absM > 0.0 ? m / absM : Complex(1.0);
  const Complex i(0.0, 1.0);
  const double a = 2.0 * ps + 4.0 * s * pss, c = 2.0 * pt + 4.0 * t * ptt;
  const double b = 4.0 * absP * absM * pst;
  // The eigenvectors of [a b; b c] by the angle of the larger one.
  const double half = 0.5 * (a - c), middle = 0.5 * (a + c),
               radius = std::sqrt(half * half + b * b);
  const double angle = 0.5 * portable::atan2(b, half);
  const double cosine = portable::cos(angle), sine = portable::sin(angle);
  jet.curvature = {2.0 * ps, 2.0 * pt, middle + radius, middle - radius};
  jet.alongP = {i * unitP, 0.0, cosine * unitP, -sine * unitP};
  jet.alongM = {0.0, i * unitM, sine * unitM, cosine * unitM};
  const double largest = *std::max_element(jet.curvature.begin(), jet.curvature.end());
  const double slope = kneeSlope(exponents, jet.value);
  for (double& curvature : jet.curvature)
    curvature = slope * std::max(curvature, kSmallestCurvature * largest);
  jet.gradientP *= slope;
  jet.gradientM *= slope;
  jet.value = bent(exponents, jet.value);
  return jet;
}

}  // namespace hgp
