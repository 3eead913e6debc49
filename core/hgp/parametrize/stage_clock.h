// Times of stages, in the order run.  Role: reports and benchmarks.
#pragma once

#include <chrono>
#include <vector>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// What a stage returns when its caller cancelled.
inline Failure cancelled(Stage stage) {
  return {ErrorCode::kCancelled, stageName(stage), "Cancelled.", {}};
}

/// Closes a stage's time and reports the next one.
class StageClock {
 public:
  StageClock(const Progress& progress, std::vector<StageTime>& times)
      : progress_(progress), times_(times) {}
  ~StageClock() { end(); }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;
  /// False when the caller cancelled.
  bool begin(Stage stage) {
    end();
    stage_ = stage;
    isRunning_ = true;
    start_ = std::chrono::steady_clock::now();
    return report(progress_, {stage, 0.0});
  }
  /// Names the stage that was begun last.
  Failure cancelled() const { return hgp::cancelled(stage_); }
  void end() {
    if (!isRunning_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    times_.push_back({stage_, spent.count()});
    isRunning_ = false;
  }

 private:
  const Progress& progress_;
  std::vector<StageTime>& times_;
  Stage stage_ = Stage::kPrepare;
  bool isRunning_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace hgp
