// The distortion energy of one triangle and its derivatives.  Role: the family of energies that
// improve() minimises, from angles to areas with symmetric Dirichlet in the middle.
#pragma once

#include <array>

#include "hgp/base/turns.h"

namespace hgp {

/// Exponents of the family (Degener, Meseth and Klein 2003)
///
///   ψ = K^angle · D^area,   K = ½ (σ₁/σ₂ + σ₂/σ₁),   D = ½ (σ₁σ₂ + 1/(σ₁σ₂)),
///
/// both factors 1 at an isometry and infinite where the triangle degenerates. angle = area = 1 is
/// symmetric Dirichlet, ¼ (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²) = K · D.
///
/// With a knee κ the energy is 1 + φ(ψ − 1),
///
///   φ(k) = 2κ (√(1 + k/κ) − 1) = k + O(k²/κ),
///
/// which grows like k below κ and like √k above it. Since K − 1 = 2μ²/(1 − μ²), the mean is then closer to that of
/// |μ| than to that of |μ|², and a few bad triangles do not dominate it.
struct EnergyExponents {
  double angle = 1.0;
  double area = 1.0;
  double knee = kNoKnee;
  static constexpr double kNoKnee = 1e300;
};

/// The exponents for a balance from −1 (angles) through 0 (isometry) to +1 (areas):
/// angle = min(1, 1 − balance), area = min(1, 1 + balance), each at least a small minimum that keeps the
/// other distortion bounded. Towards −1 the knee decreases from a very large value.
EnergyExponents exponentsAt(double balance);

/// φ′(ψ − 1), 1 without a knee.
double kneeSlope(const EnergyExponents& exponents, double psi);

/// ψ, or 1 + φ(ψ − 1), of a triangle with f_z = p and f_z̄ = m; +∞ unless |p| > |m|.
///   K = (|p|² + |m|²)/(|p|² − |m|²),  σ₁σ₂ = |p|² − |m|²
double energy(const EnergyExponents& exponents, const Complex& p, const Complex& m);

/// Gradient and a positive semidefinite Hessian of ψ as a function of (p, m) ∈ ℝ⁴. With a knee, the Hessian omits the
/// term of φ″: φ is concave, so that this is a majorizer (iteratively reweighted least squares).
struct EnergyJet {
  double value;
  Complex gradientP, gradientM;  ///< ∂ψ/∂Re + i ∂ψ/∂Im
  /// Σ curvature_k (Re(conj(alongP_k) dp) + Re(conj(alongM_k) dm))²: the eigenvalues and the
  /// eigenvectors of the Hessian, negative eigenvalues replaced by small positive ones.
  std::array<double, 4> curvature;
  std::array<Complex, 4> alongP, alongM;
};

/// The Hessian of an isotropic energy in closed form (Smith, de Goes and Kim 2019). In p and m it is
/// simplest: with s = |p|², t = |m|² the directions ip/|p| and im/|m| are eigenvectors with
/// eigenvalues 2ψ_s and 2ψ_t; the directions p/|p| and m/|m| carry the 2 × 2 block
///   [ 2ψ_s + 4sψ_ss   4√(st) ψ_st ; 4√(st) ψ_st   2ψ_t + 4tψ_tt ].
/// @pre |p| > |m|
EnergyJet energyJet(const EnergyExponents& exponents, const Complex& p, const Complex& m);

}  // namespace hgp
