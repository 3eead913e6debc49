// Progress on standard error: a bar on a terminal, plain lines elsewhere.  Role: what a person sees
// while the program works.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "hgp/base/progress.h"
#include "terminal.h"

namespace hgp::cli {

/// A terminal that knows colours and can go back on a line; TERM says "dumb" where it cannot.
bool isCleverTerminal(Stream stream);

class ProgressLine {
 public:
  /// @param isShown    false: silent, only the time limit counts
  ProgressLine(bool isShown, std::optional<double> timeLimit);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  Progress callback();
  /// Takes the bar off the terminal.
  void clear();
  bool isTimedOut() const { return isTimedOut_; }

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const ProgressReport& report);
  void printLine(const ProgressReport& report);

  bool isShown_, isTerminal_;
  std::optional<double> timeLimit_;
  bool isTimedOut_ = false, isDrawn_ = false;
  std::optional<Stage> stage_;
  int lineCount_ = 0;
  Clock::time_point start_, last_;
};

}  // namespace hgp::cli
