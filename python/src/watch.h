// Progress, interruption and the time limit of one call.  Role: what Python does while the core computes without the
// GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <optional>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"

namespace hgp::python {

namespace py = pybind11;

/// Calls `callback(stage, fraction, iteration, residual, round, max_rounds, seconds, mesh)` at every change of stage or
/// mesh and every tenth of a second; False cancels. Signals such as Ctrl-C are handled twenty times a second.
class Watch {
 public:
  /// @param callback  may be None  @param timeLimit  seconds; raises UsageError if it is not above 0
  Watch(py::object callback, std::optional<double> timeLimit);

  Progress progress();
  /// What is reported from now on is about this mesh of the file.
  void begin(int mesh);
  /// Raises what the callback or a signal handler raised; otherwise the failure. @pre the GIL is held
  [[noreturn]] void raise(Failure failure);

 private:
  using Clock = std::chrono::steady_clock;
  bool step(const ProgressReport& report);
  bool call(const ProgressReport& report, double elapsed);

  py::object callback_;
  std::optional<double> timeLimit_;
  Clock::time_point start_;
  double lastCall_ = -1.0, lastSignals_ = 0.0;
  Stage stage_ = Stage::kPrepare;
  int mesh_ = 0;
  bool isTimedOut_ = false;
  std::exception_ptr raised_;
};

}  // namespace hgp::python
