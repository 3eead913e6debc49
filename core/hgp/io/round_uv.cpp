#include "hgp/io/round_uv.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>

#include "hgp/io/rounding_groups.h"
#include "hgp/mesh/box.h"

namespace hgp::io {
namespace {

constexpr int kMendPasses = 8;  ///< over the triangles that rounding flipped
constexpr int kReach = 2;       ///< grid steps that a vertex may be moved
/// A group whose extent is outside of these is scaled, as its seams would be accepted only within rounding that is
/// coarse beside it, or its numbers would leave float32's integers behind; one inside keeps its size, which users know.
constexpr double kMinExtent = 32.0, kMaxExtent = 1e6;
constexpr int kScaledExponent = 6;          ///< to an extent from 2⁶ up to 2⁷
constexpr double kFloatSteps = 16777216.0;  ///< 2²⁴: integers up to here are exact in float32

/// Twice the signed area. Grid coordinates are integers up to 2²⁴, so the result is exact in a double.
double doubleArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

struct Frame {
  double scale = 1.0;    ///< a power of two
  Vec2 shift{0.0, 0.0};  ///< after scaling
};

struct Candidate {
  std::vector<Vec2> grid;  ///< integers
  double step = 1.0;
  std::vector<int> broken;  ///< triangles whose area is no longer positive
  bool isFine = true;       ///< the step is small enough for the tolerance of seams
};

class Rounder {
 public:
  Rounder(const MeshData& mesh, const UvMap& map) : mesh_(mesh), map_(map) {
    isUsed_.assign(map.uv.size(), 0);
    const bool isWellFormed = map.cornerUv.size() == mesh.triangles.size();
    for (std::size_t t = 0; isWellFormed && t < map.cornerUv.size(); ++t) {
      bool isWhole = true;
      for (int c : map.cornerUv[t]) {
        isRoundable_ = isRoundable_ && c < static_cast<int>(map.uv.size());
        isWhole = isWhole && c >= 0;
        if (isRoundable_ && c >= 0) isUsed_[static_cast<std::size_t>(c)] = 1;
      }
      if (isRoundable_ && isWhole && area(map.uv, t) > 0) {
        positive_.push_back(static_cast<int>(t));
      }
    }
    isRoundable_ = isRoundable_ && isWellFormed;
    findBox();
  }

  /// Rounds without moving or scaling the group.
  UvMap runInPlace() { return isRoundable_ ? finish(attempt({})) : map_; }

  UvMap run() {
    if (!isRoundable_) return map_;
    Candidate best = attempt({});
    if (isGood(best)) return finish(best);
    const double extent = box_.extent();
    consider(best, attempt(centred(1.0)));
    if (!isGood(best) && extent > 0 && (extent < kMinExtent || extent > kMaxExtent)) {
      consider(best, attempt(centred(std::ldexp(1.0, kScaledExponent - std::ilogb(extent)))));
    }
    return finish(best);
  }

 private:
  double area(const std::vector<Vec2>& uv, std::size_t t) const {
    const auto& c = map_.cornerUv[t];
    return doubleArea(uv[static_cast<std::size_t>(c[0])], uv[static_cast<std::size_t>(c[1])],
                      uv[static_cast<std::size_t>(c[2])]);
  }

  void findBox() {
    for (std::size_t i = 0; isRoundable_ && i < map_.uv.size(); ++i) {
      if (!isUsed_[i]) continue;
      const Vec2& p = map_.uv[i];
      isRoundable_ = std::abs(p[0]) < 1e37 && std::abs(p[1]) < 1e37;  // false for NaN as well
      box_.add(p);
    }
    isRoundable_ = isRoundable_ && !box_.isEmpty;
  }

  static bool isGood(const Candidate& c) { return c.isFine && c.broken.empty(); }

  static void consider(Candidate& best, Candidate other) {
    if (isGood(best)) return;
    const bool isBetter =
        best.isFine == other.isFine ? other.broken.size() < best.broken.size() : other.isFine;
    if (isBetter) best = std::move(other);
  }

  /// Centres u at 0 and v at ½, so that v and 1 − v are of the same size.
  Frame centred(double scale) const {
    return {scale,
            {-scale * (box_.low[0] + box_.high[0]) / 2,
             0.5 - scale * (box_.low[1] + box_.high[1]) / 2}};
  }

  Candidate attempt(const Frame& frame) {
    Candidate out;
    std::vector<Vec2> placed(map_.uv.size(), Vec2{0, 0});
    double reach = 0, bound = 0;
    for (std::size_t i = 0; i < placed.size(); ++i) {
      if (!isUsed_[i]) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        placed[i][k] = frame.scale * map_.uv[i][k] + frame.shift[k];
        reach = std::max(reach, std::abs(placed[i][k]));
      }
      bound = std::max({bound, reach, std::abs(1.0 - placed[i][1])});
    }
    int exponent = 0;
    const double fraction = std::frexp(bound, &exponent);
    out.step = std::ldexp(1.0, exponent - (fraction == 0.5 ? 25 : 24));
    // The verifier accepts seam errors of 16 ulps of the largest coordinate; rounding may take a few of them.
    out.isFine = out.step * kFloatSteps <= 4 * reach && out.step <= 1;
    for (Vec2& p : placed) {
      for (double& x : p) x = std::nearbyint(x / out.step);
    }
    out.grid = std::move(placed);
    findBroken(out);
    for (int pass = 0; pass < kMendPasses && !out.broken.empty(); ++pass) {
      if (!repair(out)) break;
      findBroken(out);
    }
    return out;
  }

  void findBroken(Candidate& c) const {
    c.broken.clear();
    for (int t : positive_) {
      if (!(area(c.grid, static_cast<std::size_t>(t)) > 0)) c.broken.push_back(t);
    }
  }

  /// Moves each free vertex of a broken triangle to where the smallest area around it is largest.
  bool repair(Candidate& c) {
    prepareRepair();
    bool isAnyMoved = false;
    for (int t : c.broken) {
      for (int corner : map_.cornerUv[static_cast<std::size_t>(t)]) {
        isAnyMoved = moveVertex(c, static_cast<std::size_t>(corner)) || isAnyMoved;
      }
    }
    return isAnyMoved;
  }

  double smallestArea(const Candidate& c, std::size_t uv) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (int k = firstFace_[uv]; k < firstFace_[uv + 1]; ++k) {
      smallest = std::min(
          smallest, area(c.grid, static_cast<std::size_t>(faces_[static_cast<std::size_t>(k)])));
    }
    return smallest;
  }

  bool moveVertex(Candidate& c, std::size_t uv) const {
    if (isTied_[uv]) return false;
    const Vec2 start = c.grid[uv];
    Vec2 best = start;
    double bestArea = smallestArea(c, uv);
    for (int du = -kReach; du <= kReach; ++du) {
      for (int dv = -kReach; dv <= kReach; ++dv) {
        c.grid[uv] = {start[0] + du, start[1] + dv};
        const double limit = kFloatSteps - 1;
        if (std::abs(c.grid[uv][0]) > limit || std::abs(c.grid[uv][1]) > limit ||
            std::abs(1.0 / c.step - c.grid[uv][1]) > limit) {
          continue;
        }
        const double candidate = smallestArea(c, uv);
        if (candidate > bestArea) {
          bestArea = candidate;
          best = c.grid[uv];
        }
      }
    }
    c.grid[uv] = best;
    return best != start;
  }

  /// Finds the faces around every uv, and the uv on seams, which may not be moved: the seam would no longer match.
  void prepareRepair() {
    if (!firstFace_.empty()) return;
    firstFace_.assign(map_.uv.size() + 1, 0);
    for (int t : positive_) {
      for (int c : map_.cornerUv[static_cast<std::size_t>(t)])
        ++firstFace_[static_cast<std::size_t>(c) + 1];
    }
    for (std::size_t i = 1; i < firstFace_.size(); ++i) firstFace_[i] += firstFace_[i - 1];
    faces_.resize(static_cast<std::size_t>(firstFace_.back()));
    std::vector<int> at(firstFace_.begin(), firstFace_.end() - 1);
    for (int t : positive_) {
      for (int c : map_.cornerUv[static_cast<std::size_t>(t)]) {
        faces_[static_cast<std::size_t>(at[static_cast<std::size_t>(c)]++)] = t;
      }
    }
    isTied_.assign(map_.uv.size(), 0);
    std::unordered_map<std::uint64_t, std::array<int, 2>> sides;
    const auto key = [](int a, int b) {
      return static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32 |
             static_cast<std::uint32_t>(b);
    };
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        sides[key(mesh_.triangles[t][k], mesh_.triangles[t][(k + 1) % 3])] = {
            map_.cornerUv[t][k], map_.cornerUv[t][(k + 1) % 3]};
      }
    }
    for (const auto& [edge, uv] : sides) {
      const auto twin = sides.find(edge << 32 | edge >> 32);
      if (twin == sides.end() || (twin->second[0] == uv[1] && twin->second[1] == uv[0])) continue;
      for (int c : {uv[0], uv[1]}) {
        if (c >= 0) isTied_[static_cast<std::size_t>(c)] = 1;
      }
    }
  }

  UvMap finish(const Candidate& c) const {
    UvMap out = map_;
    for (std::size_t i = 0; i < out.uv.size(); ++i) {
      if (isUsed_[i]) out.uv[i] = {c.grid[i][0] * c.step + 0.0, c.grid[i][1] * c.step + 0.0};
    }
    return out;
  }

  const MeshData& mesh_;
  const UvMap& map_;
  std::vector<char> isUsed_;
  std::vector<int> positive_;
  bool isRoundable_ = true;
  Box<2> box_;
  std::vector<int> firstFace_, faces_;
  std::vector<char> isTied_;
};

bool isWellFormed(const MeshData& mesh, const UvMap& map) {
  const auto count = static_cast<int>(map.uv.size());
  return map.cornerUv.size() == mesh.triangles.size() &&
         std::all_of(map.cornerUv.begin(), map.cornerUv.end(), [&](const auto& t) {
           return std::all_of(t.begin(), t.end(), [&](int c) { return c < count; });
         });
}

}  // namespace

UvMap roundToFloat32(const MeshData& mesh, const UvMap& map, const std::vector<int>& partOf) {
  if (!isWellFormed(mesh, map)) return map;
  UvMap out = map;
  for (const RoundingGroup& g : roundingGroups(mesh, map, partOf)) {
    Rounder rounder(g.mesh, g.map);
    const UvMap rounded = g.isFollowing ? rounder.runInPlace() : rounder.run();
    for (std::size_t i = 0; i < g.uvOrigin.size(); ++i)
      out.uv[static_cast<std::size_t>(g.uvOrigin[i])] = rounded.uv[i];
  }
  return out;
}

}  // namespace hgp::io
