// The convex program of one round.  Role: states [BCW17 (11)–(13)] as a socp::Problem, solves it, and
// translates the solution back into a map.
#pragma once

#include <vector>

#include "hgp/optimize/frames.h"
#include "hgp/optimize/program_options.h"
#include "hgp/socp/solve.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// What one program returned.
struct ProgramResult {
  std::vector<Complex> z;  ///< |V_c| positions
  Eigen::VectorXcd x;      ///< the unknowns they come from
  socp::SolveStatus status = socp::SolveStatus::kStalled;
  int iterations = 0;
  double multiplyAdds = 0.0;     ///< of its factorizations
  double laplacianEnergy = 0.0;  ///< ‖Lz‖², rows normalised to Σw = 1
  std::vector<FaceId>
      strained;  ///< if isWithoutPoint(status): constrained triangles with the largest duals
};

/// minimise ‖D L z‖² + distortion [BCW17 (11)], over seamless z (12), subject to
///   Re(f_z d̄_j) − |f_z̄| ≥ ε e^{u_f} on the frames' faces [BCW17 (13)],  D = diag(e^{−u_v}).
/// With a Patch, over its free unknowns only; each frame's triangle must contain one of them.
ProgramResult solveProgram(const SeamlessSystem& system, const Frames& frames,
                           const ProgramOptions& options);

}  // namespace hgp
