// Untangling: from a seamless map with flipped triangles to a nearby one without.  Role: used where no set of
// frames gives a locally injective map; it has no frame conditions.
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

/// Minimises over seamless maps, by projected Newton steps with a line search [GKK21],
///
///   Σ_f (|f_z|² + |f_z̄|² + λ (D² + 1)) / χ(D, ε),   D = |f_z|² − |f_z̄|²,  χ = ½ (D + √(D² + ε²)),
///
/// each triangle in units of e^{u_f}, while ε shrinks with the most negative D. For ε → 0 and
/// D > 0 that is the conformal energy with a weak bound on scale: a barrier against flips. In a first phase
/// |f_z|² in D is replaced by A √(A² + ε), A the part of f_z along the frames of `system.seams` (framedModel), which decides
/// the winding numbers and opens what has collapsed; from time to time the frames are rotated smoothly after the map, which keeps their holonomy.
/// Ends soon after the last flip. The map is not harmonic.
/// @param x  the initial unknowns, any values
UntangleResult untangle(const SeamlessSystem& system, const Eigen::VectorXcd& x,
                        const UntangleOptions& options);

}  // namespace hgp
