#include "work_span.h"

#include <algorithm>
#include <ctime>

namespace hgp::bench {
namespace {

double now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace

WorkSpanMeter::WorkSpanMeter() : last_(now()) {}

void WorkSpanMeter::tick() {
  const double time = now();
  open_.back().sum.work += time - last_;
  open_.back().sum.span += time - last_;
  last_ = time;
}

void WorkSpanMeter::workBegins() {
  tick();
  open_.emplace_back();
}

void WorkSpanMeter::workEnds() {
  const WorkSpan sum = open_.back().sum;
  open_.pop_back();
  open_.back().sum.work += sum.work;
  open_.back().sum.span += sum.span;
  if (open_.size() == 1) shared_.push_back(sum);
  last_ = now();
}

void WorkSpanMeter::pieceBegins(int) {
  last_ = now();
  open_.emplace_back();
}

void WorkSpanMeter::pieceEnds(int piece, int next) {
  tick();
  const WorkSpan sum = open_.back().sum;
  open_.pop_back();
  Open& work = open_.back();
  const auto least = static_cast<std::size_t>(std::max(piece, next)) + 1;
  if (work.waited.size() < least) work.waited.resize(least, 0.0);
  const double end = work.waited[static_cast<std::size_t>(piece)] + sum.span;
  if (next >= 0) {
    double& before = work.waited[static_cast<std::size_t>(next)];
    before = std::max(before, end);
  }
  work.sum.work += sum.work;
  work.sum.span = std::max(work.sum.span, end);
}

WorkSpan WorkSpanMeter::total() {
  tick();
  return open_.front().sum;
}

std::array<double, 2> WorkSpanMeter::seconds(int threads) const {
  WorkSpan serial = open_.front().sum;
  std::array<double, 2> out{};
  for (const auto& [work, span] : shared_) {
    serial.work -= work;
    out[0] += std::max(work / threads, span);
    out[1] += work / threads + (1.0 - 1.0 / threads) * span;
  }
  return {out[0] + serial.work, out[1] + serial.work};
}

}  // namespace hgp::bench
