#include "progress_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace hgp::cli {
namespace {

constexpr double kBarSeconds = 0.1;   // between two drawings of the bar
constexpr double kLineSeconds = 5.0;  // between two plain lines of one stage
constexpr int kBarWidth = 24;

/// Whether the residual is the excess of an energy, as in the stages kImprove and kAlign.
bool isImprovement(const ProgressReport& report) {
  return (report.stage == Stage::kImprove || report.stage == Stage::kAlign) && report.residual >= 0;
}

}  // namespace

bool isCleverTerminal(Stream stream) {
  const char* kind = std::getenv("TERM");
  return isTerminal(stream) && kind != nullptr && std::string_view(kind) != "dumb";
}

ProgressLine::ProgressLine(bool isShown, std::optional<double> timeLimit)
    : isShown_(isShown),
      isTerminal_(isCleverTerminal(Stream::kError)),
      timeLimit_(timeLimit),
      start_(Clock::now()),
      last_(start_ - std::chrono::hours(1)) {}

ProgressLine::~ProgressLine() { clear(); }

Progress ProgressLine::callback() {
  return [this](const ProgressReport& report) {
    const Clock::time_point now = Clock::now();
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    if (timeLimit_ && elapsed > *timeLimit_) {
      isTimedOut_ = true;
      return false;
    }
    if (!isShown_) return true;
    // Each stage is announced once per file, not for every component and mesh; after that, lines come by time.
    const bool isNewStage = announced_.insert(report.stage).second;
    const double pause = std::chrono::duration<double>(now - last_).count();
    if (pause < (isTerminal_ ? kBarSeconds : kLineSeconds) && !(isNewStage && !isTerminal_))
      return true;
    last_ = now;
    if (isTerminal_)
      draw(report);
    else
      printLine(report);
    return true;
  };
}

void ProgressLine::draw(const ProgressReport& report) {
  const double fraction = std::clamp(report.fraction, 0.0, 1.0);
  const int full = static_cast<int>(std::lround(fraction * kBarWidth));
  const std::string bar = std::string(static_cast<std::size_t>(full), '#') +
                          std::string(static_cast<std::size_t>(kBarWidth - full), '.');
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  std::fprintf(stderr, "\r\033[K[%s] %3.0f%%  %-12s %5.1f s", bar.c_str(), 100 * fraction,
               stageName(report.stage), elapsed);
  if (report.round > 0) std::fprintf(stderr, "  round %d of %d", report.round, report.maxRounds);
  if (report.iteration >= 0) std::fprintf(stderr, "  iteration %d", report.iteration);
  if (report.residual >= 0)
    std::fprintf(stderr, isImprovement(report) ? "  energy %.4g" : "  gap %.1e", report.residual);
  std::fflush(stderr);
  isDrawn_ = true;
}

void ProgressLine::printLine(const ProgressReport& report) {
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  std::fprintf(stderr, "hgp: %6.1f s  %s", elapsed, stageName(report.stage));
  if (report.round > 0) std::fprintf(stderr, ", round %d of %d", report.round, report.maxRounds);
  if (report.iteration >= 0) std::fprintf(stderr, ", iteration %d", report.iteration);
  if (isImprovement(report)) std::fprintf(stderr, ", energy %.4g", report.residual);
  std::fputc('\n', stderr);
}

void ProgressLine::clear() {
  if (!isDrawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  isDrawn_ = false;
}

}  // namespace hgp::cli
