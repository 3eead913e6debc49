// Progress and cancellation.  Role: the only way a stage talks while it works.
#pragma once

#include <functional>

namespace hgp {

/// One report. `fraction` is of the named stage, in [0, 1].
struct ProgressReport {
  const char* stage = "";
  double fraction = 0.0;
  int iteration = -1;  ///< solver iteration, −1 outside the solver
  /// Solver residual relative to its target; in stages "improve" and "align" the energy's excess over an
  /// isometry while it descends; −1 outside.
  double residual = -1.0;
  int round = 0;      ///< of solve, judge, repair: the first is 1; 0 outside
  int maxRounds = 0;  ///< rounds at most; 0 outside
};

/// Called inside every solver iteration and between stages. Return false to cancel.
using Progress = std::function<bool(const ProgressReport&)>;

/// Reports when there is somebody to report to; true means keep going.
inline bool report(const Progress& progress, const ProgressReport& r) {
  return !progress || progress(r);
}

}  // namespace hgp
