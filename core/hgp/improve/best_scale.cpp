#include "hgp/improve/best_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

constexpr int kScaleSteps = 60;
constexpr double kScaleTolerance = 1e-6;

}  // namespace

double meanEnergy(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                  double scale) {
  double sum = 0.0;
  for (std::size_t f = 0; f < parts.similar.size(); ++f)
    sum += terms.weight(static_cast<int>(f)) *
           energy(exponents, parts.similar[f] / scale, parts.anti[f] / scale);
  return sum;
}

double bestScale(const EnergyExponents& exponents, const FaceTerms& terms, const FaceParts& parts,
                 double start) {
  // ψ = K^a D^b; with v = log σ₁σ₂ − 2τ: D = cosh v, ∂ψ/∂τ = −2bψ tanh v,
  // ∂²ψ/∂τ² = 4bψ (b tanh² v + 1 − tanh² v).
  double grown = 0.0, shrunk = 0.0;
  std::vector<double> shape(parts.similar.size()), logArea(parts.similar.size());
  for (std::size_t f = 0; f < shape.size(); ++f) {
    const double p = std::norm(parts.similar[f]), m = std::norm(parts.anti[f]);
    const double d = p - m;
    const double K = (p + m) / d;
    shape[f] = terms.weight(static_cast<int>(f)) *
               (exponents.angle == 1.0 ? K : portable::pow(K, exponents.angle));
    logArea[f] = portable::log(d);
    grown += shape[f] * d;
    shrunk += shape[f] / d;
  }
  if (exponents.area == 1.0 && exponents.knee == EnergyExponents::kNoKnee)
    return portable::pow(grown / shrunk, 0.25);
  double tau = portable::log(start);
  // Far from the minimum the slope hardly changes and Newton steps are too long, so the minimum is bracketed.
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (int step = 0; step < kScaleSteps; ++step) {
    double gradient = 0.0, curvature = 0.0;
    for (std::size_t f = 0; f < shape.size(); ++f) {
      const double v = logArea[f] - 2.0 * tau, tanh = portable::tanh(v);
      double psi = shape[f] * portable::pow(portable::cosh(v), exponents.area);
      psi *= kneeSlope(exponents, psi / terms.weight(static_cast<int>(f)));
      gradient -= psi * tanh;
      curvature += 2.0 * psi * (1.0 + (exponents.area - 1.0) * tanh * tanh);
    }
    const double change = -gradient / curvature;
    if (!std::isfinite(change)) break;
    (change > 0.0 ? low : high) = tau;
    const double next = tau + std::clamp(change, -2.0, 2.0);
    const double before = tau;
    tau = low < next && next < high ? next : 0.5 * (low + high);
    if (std::fabs(tau - before) < kScaleTolerance) break;
  }
  return portable::exp(tau);
}

}  // namespace hgp
