#include "slim.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "processor_time.h"

namespace hgp::bench {
namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Weight of the proximal term relative to the mean diagonal, needed because rigid motions do not change the energy.
constexpr double kProximal = 1e-6;
/// Maximum step as a fraction of the step at which the first triangle degenerates.
constexpr double kDegeneracyShare = 0.8;
constexpr double kShortestStep = 1e-9;

/// σ₁² + σ₂² + σ₁⁻² + σ₂⁻² of f_z = p, f_z̄ = m; +∞ unless |p| > |m|.
double symmetricDirichlet(const Complex& p, const Complex& m) {
  const double large = std::abs(p) + std::abs(m), small = std::abs(p) - std::abs(m);
  if (!(small > 0.0)) return std::numeric_limits<double>::infinity();
  return large * large + small * small + 1.0 / (large * large) + 1.0 / (small * small);
}

double meanEnergy(const FaceTerms& terms, const FaceParts& parts) {
  double sum = 0.0;
  for (int f = 0; f < terms.faceCount(); ++f)
    sum += terms.weight(f) * symmetricDirichlet(parts.similar[at(f)], parts.anti[at(f)]);
  return sum;
}

/// The proxy energy of one triangle. W c = a c + b c̄ for a vector c of the plane, so that with P = p − r and r the
/// rotation, ‖W (J − R)‖² = 2 (|a P + b m̄|² + |a m + b P̄|²).
struct Proxy {
  double a;
  Complex b, rotation;
};

double proxyWeight(double s) { return std::sqrt((1.0 + s) * (1.0 + s * s) / (s * s * s)); }

Proxy proxyOf(const Complex& p, const Complex& m) {
  const double absP = std::abs(p), absM = std::abs(m);
  const double w1 = proxyWeight(absP + absM), w2 = proxyWeight(absP - absM);
  // U's first column has the angle (arg p + arg m)/2.
  const Complex twice = absM > 0.0 ? (p / absP) * (m / absM) : Complex(0.0);
  return {0.5 * (w1 + w2), 0.5 * (w1 - w2) * twice, p / absP};
}

/// Normal equations of all proxies over the unknowns as real pairs.
class GlobalStep {
 public:
  explicit GlobalStep(const FaceTerms& terms) : terms_(terms) {}

  /// The minimiser of the proxy energies around `parts`, as a change of y.
  Eigen::VectorXcd change(const FaceParts& parts) {
    const Eigen::Index n = 2 * static_cast<Eigen::Index>(terms_.freeCount());
    entries_.clear();
    residual_ = Eigen::VectorXd::Zero(n);
    diagonal_ = 0.0;
    for (int f = 0; f < terms_.faceCount(); ++f)
      addTriangle(f, parts.similar[at(f)], parts.anti[at(f)]);
    for (Eigen::Index i = 0; i < n; ++i)
      entries_.emplace_back(i, i, kProximal * diagonal_ / static_cast<double>(n));
    SparseMatrix normal(n, n);
    normal.setFromTriplets(entries_.begin(), entries_.end());
    if (!isAnalyzed_) solver_.analyzePattern(normal);
    isAnalyzed_ = true;
    solver_.factorize(normal);
    if (solver_.info() != Eigen::Success) return {};
    const Eigen::VectorXd solved = solver_.solve(-residual_);
    Eigen::VectorXcd change(terms_.freeCount());
    for (int i = 0; i < terms_.freeCount(); ++i) change[i] = {solved[2 * i], solved[2 * i + 1]};
    return change;
  }

 private:
  void addTriangle(int f, const Complex& p, const Complex& m) {
    const auto terms = terms_.terms(f);
    const Proxy proxy = proxyOf(p, m);
    const double weight = 2.0 * terms_.weight(f);
    // Columns of a P + b m̄ and a m + b P̄ over (Re dy, Im dy): 4 real rows.
    rows_.resize(4, 2 * static_cast<Eigen::Index>(terms.size()));
    for (Eigen::Index i = 0; i < rows_.cols() / 2; ++i) {
      const Complex s = terms[static_cast<std::size_t>(i)].similar;
      const Complex t = terms[static_cast<std::size_t>(i)].anti;
      const Complex direct[2] = {proxy.a * s, proxy.a * t};
      const Complex mirrored[2] = {proxy.b * std::conj(t), proxy.b * std::conj(s)};
      for (int row = 0; row < 2; ++row) {
        const Complex real = direct[row] + mirrored[row];
        const Complex imaginary = Complex(0, 1) * (direct[row] - mirrored[row]);
        rows_.block<2, 2>(2 * row, 2 * i) << real.real(), imaginary.real(), real.imag(),
            imaginary.imag();
      }
    }
    const Complex dp = p - proxy.rotation;
    const Complex first = proxy.a * dp + proxy.b * std::conj(m);
    const Complex second = proxy.a * m + proxy.b * std::conj(dp);
    const Eigen::Vector4d here(first.real(), first.imag(), second.real(), second.imag());
    const Eigen::VectorXd slope = weight * (rows_.transpose() * here);
    const Eigen::MatrixXd block = weight * (rows_.transpose() * rows_);
    diagonal_ += block.trace();
    const auto index = [&](Eigen::Index k) {
      return 2 * terms[static_cast<std::size_t>(k / 2)].unknown + static_cast<int>(k % 2);
    };
    for (Eigen::Index j = 0; j < block.cols(); ++j) {
      residual_[index(j)] += slope[j];
      for (Eigen::Index i = 0; i < block.rows(); ++i)
        if (index(i) >= index(j)) entries_.emplace_back(index(i), index(j), block(i, j));
    }
  }

  const FaceTerms& terms_;
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd residual_;
  Eigen::Matrix<double, 4, Eigen::Dynamic> rows_;
  double diagonal_ = 0.0;
  bool isAnalyzed_ = false;
  Eigen::SimplicialLDLT<SparseMatrix> solver_;
};

/// y and the quantities computed from it.
struct State {
  Eigen::VectorXcd y;
  FaceParts parts;
  double energy = 0.0;
};

/// Line search: starts with the longest step without a degenerate triangle, and halves it until the energy decreases.
bool descend(const FaceTerms& terms, const Eigen::VectorXcd& change, State& state) {
  FaceParts changes;
  evaluateParts(terms, change, true, changes);
  const double limit = stepToDegeneracy(state.parts, changes, 2.0);
  State trial;
  for (double step = std::min(1.0, kDegeneracyShare * limit); step > kShortestStep; step *= 0.5) {
    trial.y = state.y + step * change;
    evaluateParts(terms, trial.y, false, trial.parts);
    trial.energy = meanEnergy(terms, trial.parts);
    if (!(trial.energy < state.energy)) continue;
    state = std::move(trial);
    return true;
  }
  return false;
}

}  // namespace

SlimResult slim(const FaceTerms& terms, const Eigen::VectorXcd& start, const SlimOptions& options) {
  const double began = processorSeconds();
  State state{start, {}, 0.0};
  evaluateParts(terms, state.y, false, state.parts);
  state.energy = meanEnergy(terms, state.parts);
  SlimResult result;
  result.energies.push_back(state.energy);
  GlobalStep global(terms);
  for (int n = 0; n < options.maxSteps && std::isfinite(state.energy); ++n) {
    result.isLate = options.maxSeconds > 0.0 && processorSeconds() - began > options.maxSeconds;
    const double before = state.energy;
    if (result.isLate || before - 4.0 < 1e-12) break;
    const Eigen::VectorXcd change = global.change(state.parts);
    if (change.size() == 0 || !descend(terms, change, state)) break;
    result.energies.push_back(state.energy);
    if (before - state.energy <= options.relativeDecrease * (before - 4.0)) break;
  }
  result.free = std::move(state.y);
  return result;
}

}  // namespace hgp::bench
