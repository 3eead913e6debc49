// Local/global minimisation of the symmetric Dirichlet energy (SLIM).  Role: for comparison with `--improve
// isometric`; shares the linear forms of a triangle with it, but nothing of the descent.
#pragma once

#include <vector>

#include "hgp/improve/face_terms.h"

namespace hgp::bench {

struct SlimOptions {
  /// Ends when a step lowers the energy's excess over an isometry by less than this fraction.
  double relativeDecrease = 1e-3;
  int maxSteps = 60;
  double maxSeconds = 0.0;  ///< of processor time; 0 = no limit
};

struct SlimResult {
  Eigen::VectorXcd free;  ///< unknowns of the terms; the map is at scale 1 against the surface
  std::vector<double>
      energies;  ///< Σ A (σ₁² + σ₂² + σ₁⁻² + σ₂⁻²)/Σ A at the start and after each step
  bool isLate = false;  ///< stopped by maxSeconds
};

/// Scalable locally injective mappings (Rabinovich, Poranne, Panozzo and Sorkine-Hornung 2017). With
/// J = U diag(σ) Vᵀ per triangle and R = U Vᵀ, a step minimizes
///   Σ A ‖W (J(y) − R)‖²,  W = U diag(w) Uᵀ,  w_i² = (σ_i − σ_i⁻³)/(σ_i − 1) = (1 + σ_i)(1 + σ_i²)/σ_i³,
/// followed by a line search in which no triangle degenerates and the energy decreases.
/// @param terms  f_z and f_z̄ over the unknowns: reduced ones (seams stay exact) or one per copy (free)
/// @pre no triangle is degenerate or flipped at `start`
SlimResult slim(const FaceTerms& terms, const Eigen::VectorXcd& start, const SlimOptions& options);

}  // namespace hgp::bench
