// The convex program of one round.  Role: [BCW17 (11)–(13)] → socp::Problem and back, in one file.
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
  double work = 0.0;             ///< multiply-adds of its factorizations
  double laplacianEnergy = 0.0;  ///< ‖Lz‖², rows normalised to Σw = 1
  std::vector<FaceId> conflict;  ///< constrained triangles with the largest duals, if infeasible
};

/// minimise ‖D L z‖² + distortion, over seamless z, subject to
///   Re(f_z d̄_j) − |f_z̄| ≥ ε e^{u_f} on the frames' faces [BCW17 (13)],  D = diag(e^{−u_v}).
/// Of a patch, over its free unknowns alone; each frame's triangle must have one.
ProgramResult solveProgram(const SeamlessSystem& system, const Frames& frames,
                           const ProgramOptions& options);

}  // namespace hgp
