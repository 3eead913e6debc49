// Progress and cancellation.  Role: the only communication of a stage with its caller while it runs.
#pragma once

#include <cstdint>
#include <functional>

namespace hgp {

/// The parts of a run, in the order of their first appearance.
enum class Stage : std::uint8_t {
  kPrepare,     ///< topology, geometry, factors that all prescriptions share
  kCones,       ///< automatic cones are chosen
  kConnection,  ///< their distances, handles and turnings
  kField,       ///< the cross field of the prescription
  kCut,
  kAssemble,  ///< the rows of the system
  kSolve,     ///< rounds: attempt, verify, next move
  kImprove,
  kAlign,
};

/// "prepare", "cones", …, as used in reports and in the message of a cancelled run.
const char* stageName(Stage stage);

/// One report. `fraction` is of the stage, in [0, 1].
struct ProgressReport {
  Stage stage = Stage::kPrepare;
  double fraction = 0.0;
  int iteration = -1;  ///< solver iteration, −1 outside the solver
  /// Solver residual relative to its target; during the descent of kImprove and kAlign, the energy's excess over an
  /// isometry; −1 otherwise.
  double residual = -1.0;
  int round = 0;      ///< round of the loop, from 1; 0 outside the loop
  int maxRounds = 0;  ///< maximum number of rounds; 0 outside the loop
};

/// Called inside every solver iteration and between stages. Return false to cancel.
using Progress = std::function<bool(const ProgressReport&)>;

/// Calls `progress` if there is one; true means continue.
inline bool report(const Progress& progress, const ProgressReport& r) {
  return !progress || progress(r);
}

}  // namespace hgp
