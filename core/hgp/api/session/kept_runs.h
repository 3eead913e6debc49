// Runs whose results a session keeps.  Role: the same prescription, undo and redo need no second solve.
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "hgp/api/options.h"
#include "hgp/api/results.h"
#include "hgp/prescription/prescription.h"

namespace hgp::api {

/// Everything that determines the bytes of a result on one surface.
struct RunKey {
  std::optional<prescription::Prescription> prescription;
  SolveOptions options;  ///< `progress` does not matter
  bool isReproducible = false;
};
bool isSame(const RunKey& a, const RunKey& b);

/// The last results of one surface: at most kMaxRuns, of at most kMaxTriangles in total.
template <class Value>
class KeptRuns {
 public:
  static constexpr std::size_t kMaxRuns = 12;
  static constexpr std::size_t kMaxTriangles = 1'000'000;

  /// Null if there was no such run, or its result is no longer kept. It becomes the newest.
  const Value* find(const RunKey& key) {
    for (std::size_t i = runs_.size(); i-- > 0;) {
      if (!isSame(runs_[i].key, key)) continue;
      std::rotate(runs_.begin() + static_cast<std::ptrdiff_t>(i),
                  runs_.begin() + static_cast<std::ptrdiff_t>(i) + 1, runs_.end());
      return &runs_.back().value;
    }
    return nullptr;
  }
  void add(RunKey key, std::size_t triangles, Value value) {
    if (triangles > kMaxTriangles / 2) return;
    key.options.progress = nullptr;
    runs_.push_back({std::move(key), std::move(value)});
    const std::size_t most =
        std::min(kMaxRuns, kMaxTriangles / std::max<std::size_t>(1, triangles));
    if (runs_.size() > most) runs_.erase(runs_.begin());
  }
  void clear() { runs_.clear(); }

 private:
  struct Run {
    RunKey key;
    Value value;
  };
  std::vector<Run> runs_;  ///< the newest last
};

}  // namespace hgp::api
