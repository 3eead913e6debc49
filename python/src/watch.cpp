#include "watch.h"

#include <utility>

#include "failures.h"
#include "hgp/base/check.h"

namespace hgp::python {
namespace {

constexpr double kCallSeconds = 0.1, kSignalSeconds = 0.05;

}  // namespace

Watch::Watch(py::object callback, std::optional<double> timeLimit)
    : callback_(std::move(callback)), timeLimit_(timeLimit), start_(Clock::now()) {
  if (timeLimit && !(*timeLimit > 0)) raiseUsage("time_limit must be a number of seconds above 0");
}

Progress Watch::progress() {
  return [this](const ProgressReport& report) { return step(report); };
}

void Watch::begin(int mesh) {
  mesh_ = mesh;
  lastCall_ = -1.0;
}

bool Watch::step(const ProgressReport& report) {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (timeLimit_ && elapsed > *timeLimit_) {
    isTimedOut_ = true;
    return false;
  }
  const bool isCallDue = !callback_.is_none() && (lastCall_ < 0 || report.stage != stage_ ||
                                                  elapsed - lastCall_ >= kCallSeconds);
  if (!isCallDue && elapsed - lastSignals_ < kSignalSeconds) return true;
  const py::gil_scoped_acquire gil;
  lastSignals_ = elapsed;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return !isCallDue || call(report, elapsed);
  } catch (...) {
    raised_ = std::current_exception();
    return false;
  }
}

bool Watch::call(const ProgressReport& report, double elapsed) {
  lastCall_ = elapsed;
  stage_ = report.stage;
  const py::object answer =
      callback_(stageName(report.stage), report.fraction, report.iteration, report.residual,
                report.round, report.maxRounds, elapsed, mesh_);
  return !answer.is(py::bool_(false));
}

void Watch::raise(Failure failure) {
  if (raised_) std::rethrow_exception(raised_);
  if (isTimedOut_) {
    failure.code = ErrorCode::kNoMap;
    failure.message = formatText("no certified map within %g s (time_limit)", *timeLimit_);
  }
  python::raise(failure);
}

}  // namespace hgp::python
