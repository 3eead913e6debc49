// A seamless map without flipped triangles near one that has some.  Role: what follows where no set of
// frames gives a locally injective map; it needs no frames.
#pragma once

#include <functional>

#include "hgp/optimize/program.h"

namespace hgp {

struct UntangleOptions {
  PerVertex<double> u;  ///< log scale that triangles are measured in, as in ProgramOptions
  /// Triangles that, once positive, stay positive at every step: those around cones and along the
  /// boundary, whose angle sums then keep their multiple of 2π.
  std::vector<FaceId> kept;
  /// λ: keeps triangles from shrinking to nothing; large, it asks for equal scale.
  double scaleWeight = 0.05;
  double epsilonShare = 0.2;  ///< ε over the most negative D
  int maxIterations = 100;    ///< Newton steps without frames
  /// Called before every step with its number and the share of triangles still flipped; false cancels.
  std::function<bool(int, double)> progress;
};

struct UntangleResult {
  Eigen::VectorXcd x;  ///< the unknowns
  int iterations = 0;
  int flipped = 0;  ///< triangles whose scaled Jacobian is not positive
  bool isCancelled = false;
};

/// Minimises over seamless maps, by projected Newton steps with a line search,
///
///   Σ_f (|f_z|² + |f_z̄|² + λ (D² + 1)) / χ(D, ε),   D = |f_z|² − |f_z̄|²,  χ = ½ (D + √(D² + ε²)),
///
/// each triangle in units of e^{u_f}, while ε shrinks with the most negative D (Garanzha, Kaporin,
/// Kudryavtseva, Protais, Ray, Sokolov 2021, "Foldover-free maps in 50 lines of code"). For ε → 0 and
/// D > 0 that is conformal energy with a weak bound on scale: a barrier against flips. First with
/// |f_z|² replaced by what of it is along the frames of `system.seams`, which decides winding numbers; the
/// frames turn after the map now and then, smoothly, so that they stay as prescribed. Ends soon after
/// the last flip. The map is not harmonic.
/// @param x  where to start: any unknowns
UntangleResult untangle(const SeamlessSystem& system, const Eigen::VectorXcd& x,
                        const UntangleOptions& options);

}  // namespace hgp
