// Options and steps of an improvement.  Role: the types of improve.h that other options and reports contain;
// includes nothing.
#pragma once

namespace hgp {

struct ImproveOptions {
  /// −1: angles (as conformal as the cones allow), 0: isometric (symmetric Dirichlet), +1: areas; see
  /// exponentsAt.
  double balance = 0.0;
  /// Ends when a step lowers the energy's excess over an isometry by less than this share of it.
  double relativeDecrease = 0.01;
  int maxSteps = 40;
  double maxMultiplyAdds = 1e300;  ///< no further step that would exceed them
};

/// One Newton step.
struct ImproveStep {
  double excess = 0.0;  ///< mean ψ − 1 over the surface afterwards, at the best global scale
  double length = 0.0;  ///< accepted step length; 1 is the full Newton step
};

/// Why a descent ended.
enum class DescentOutcome {
  kConverged,
  kNothingToGain,
  kNoDescent,
  kStepLimit,
  kWorkLimit,
  kSingular,      ///< the Hessian
  kNotInjective,  ///< the map as given has triangles that are not positive
  kCancelled,
};
/// "converged", "nothing to gain", …: the words of reports.
const char* outcomeName(DescentOutcome outcome);

}  // namespace hgp
