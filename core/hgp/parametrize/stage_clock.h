// Times of stages, in the order run.  Role: reports and benchmarks.
#pragma once

#include <chrono>
#include <vector>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// What a stage returns when its caller cancelled.
inline Failure cancelled(const char* stage) {
  return {ErrorCode::kCancelled, stage, "Cancelled.", {}};
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
  bool begin(const char* stage) {
    end();
    stage_ = stage;
    start_ = std::chrono::steady_clock::now();
    return report(progress_, {stage, 0.0});
  }
  void end() {
    if (!stage_) return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    times_.push_back({stage_, spent.count()});
    stage_ = nullptr;
  }

 private:
  const Progress& progress_;
  std::vector<StageTime>& times_;
  const char* stage_ = nullptr;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace hgp
