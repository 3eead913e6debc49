#include "hgp/io/gltf/patch/split.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"

namespace hgp::io {
namespace {

Failure unwritable(const std::string& message) {
  return {ErrorCode::kWriteFailed, "write", message, {}};
}

/// The float32 pair that glTF stores for a uv; false if reading it back would give another value.
bool storedUv(const Vec2& uv, std::array<float, 2>& out) {
  if (!(std::abs(uv[0]) < 3e38 && std::abs(uv[1]) < 3e38)) return false;
  out = {static_cast<float>(uv[0]), static_cast<float>(1.0 - uv[1])};
  return static_cast<double>(out[0]) == uv[0] && 1.0 - static_cast<double>(out[1]) == uv[1];
}

/// Assigns one written vertex to each combination of stored vertex, uv and copy.
class Splitter {
 public:
  Splitter(const GltfSurface& part, GltfSplits& out) : part_(part), out_(out) {
    out_.pools.resize(part.pools.size());
    for (std::size_t p = 0; p < part.pools.size(); ++p) {
      const auto count = static_cast<std::size_t>(part.pools[p].vertexCount);
      out_.pools[p].uv.assign(2 * count, 0.0f);
      isTaken_.emplace_back(count, 0);
      copy_.emplace_back(count, 0);
      next_.emplace_back(count, -1);
    }
  }

  int vertexFor(const GltfRun& run, int stored, const std::array<float, 2>& uv, int copy) {
    const auto p = static_cast<std::size_t>(run.pool);
    GltfSplit& split = out_.pools[p];
    const auto v = static_cast<std::size_t>(local(run, stored));
    if (isTaken_[p][v] == 0) {
      isTaken_[p][v] = 1;
      split.uv[2 * v] = uv[0];
      split.uv[2 * v + 1] = uv[1];
      copy_[p][v] = copy;
    }
    for (int w = static_cast<int>(v);;) {
      const auto i = static_cast<std::size_t>(w);
      if (split.uv[2 * i] == uv[0] && split.uv[2 * i + 1] == uv[1] && copy_[p][i] == copy) return w;
      if (next_[p][i] < 0) {
        const int fresh = static_cast<int>(next_[p].size());
        next_[p][i] = fresh;
        next_[p].push_back(-1);
        copy_[p].push_back(copy);
        split.copyOf.push_back(static_cast<int>(v));
        split.uv.insert(split.uv.end(), uv.begin(), uv.end());
        return fresh;
      }
      w = next_[p][i];
    }
  }

  int local(const GltfRun& run, int stored) const {
    return stored - part_.pools[static_cast<std::size_t>(run.pool)].firstStored;
  }

 private:
  const GltfSurface& part_;
  GltfSplits& out_;
  std::vector<std::vector<char>> isTaken_;
  std::vector<std::vector<int>> copy_;  ///< of every written vertex
  std::vector<std::vector<int>> next_;  ///< next copy of the same stored vertex, by written vertex
};

}  // namespace

Result<GltfSplits> splitForUv(const GltfSurface& part, const UvMap& map) {
  if (map.cornerUv.size() != part.stored.size()) {
    return unwritable(formatText("uv for %zu triangles, but the surface has %zu",
                                 map.cornerUv.size(), part.stored.size()));
  }
  GltfSplits out;
  out.corner.resize(part.stored.size(), {-1, -1, -1});
  Splitter splitter(part, out);
  for (const GltfRun& run : part.runs) {
    for (int face = run.firstTriangle; face < run.firstTriangle + run.triangleCount; ++face) {
      const auto t = static_cast<std::size_t>(face);
      for (std::size_t k = 0; k < 3; ++k) {
        const int index = map.cornerUv[t][k];
        out.corner[t][k] = splitter.local(run, part.stored[t][k]);
        if (index < 0) continue;
        std::array<float, 2> uv{};
        if (index >= static_cast<int>(map.uv.size()) ||
            !storedUv(map.uv[static_cast<std::size_t>(index)], uv)) {
          return unwritable(
              formatText("triangle %d has a uv that float32 cannot hold; round the map "
                         "with asStored first",
                         face));
        }
        const int copy = part.copy.empty() ? 0 : std::max(part.copy[t][k], 0);
        out.corner[t][k] = splitter.vertexFor(run, part.stored[t][k], uv, copy);
      }
    }
  }
  return out;
}

}  // namespace hgp::io
