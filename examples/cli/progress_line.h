// Progress on standard error: a bar on a terminal, plain lines elsewhere.  Role: feedback for users
// during a run.
#pragma once

#include <chrono>
#include <optional>
#include <set>
#include <string>

#include "hgp/base/progress.h"
#include "terminal.h"

namespace hgp::cli {

/// Whether a terminal supports colours and can rewrite a line; if not, TERM is "dumb".
bool isCleverTerminal(Stream stream);

class ProgressLine {
 public:
  /// @param isShown    false: prints nothing and only watches the time limit
  ProgressLine(bool isShown, std::optional<double> timeLimit);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  Progress callback();
  /// Removes the bar from the terminal.
  void clear();
  bool isTimedOut() const { return isTimedOut_; }

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const ProgressReport& report);
  void printLine(const ProgressReport& report);

  bool isShown_, isTerminal_;
  std::optional<double> timeLimit_;
  bool isTimedOut_ = false, isDrawn_ = false;
  std::set<Stage> announced_;
  Clock::time_point start_, last_;
};

}  // namespace hgp::cli
