#include "surface_table.h"

#include <cstdio>

#include "child_process.h"

namespace hgp::bench {

SurfaceTable::SurfaceTable(const std::string& head, std::string (*lines)(const SurfaceRow&),
                           double cpuSeconds)
    : lines_(lines), cpuSeconds_(cpuSeconds), text_(head) {
  std::fputs(head.c_str(), stdout);
}

void SurfaceTable::add(SurfaceRow blank, const std::function<SurfaceRow()>& work) {
  const Result<std::string> text = runInChild([&] { return toJson(work()); }, {0.0, cpuSeconds_});
  if (!text) blank.failure = text.error().message;
  SurfaceRow row = text ? surfaceRowFromJson(*text) : std::move(blank);
  if (row.maps.empty() && row.failure.empty()) return;
  rows_.push_back(std::move(row));
  const std::string lines = lines_(rows_.back());
  text_ += lines;
  std::fputs(lines.c_str(), stdout);
  std::fflush(stdout);
}

}  // namespace hgp::bench
