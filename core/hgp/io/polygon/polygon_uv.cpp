#include <algorithm>
#include <cmath>
#include <complex>
#include <unordered_map>

#include "hgp/base/portable_math.h"
#include "hgp/base/turns.h"
#include "hgp/io/polygon/polygon_mesh.h"

namespace hgp::io {
namespace {

// Two copies of one vertex closer than this, relative to max |uv|, are the same copy.
constexpr double kSameCopy = 3e-14;
// A rotation this close to a multiple of π/2 is one: the difference is rounding of two subtractions.
constexpr double kQuarterTurn = 1e-9;

Complex toComplex(const Vec2& p) { return {p[0], p[1]}; }

class PolygonKeeper {
 public:
  PolygonKeeper(const PolygonMesh& polygons, const TriangleCorners& corners, const UvMap& map,
                const std::vector<int>& partOf)
      : polygons_(polygons), corners_(corners), partOf_(partOf) {
    out_.map = map;
    out_.cornerUv.assign(polygons.cornerVertex.size(), -1);
    for (const Vec2& p : map.uv) {
      largest_ = std::max({largest_, std::abs(p[0]), std::abs(p[1])});
    }
  }

  PolygonUv keep() {
    for (int p = 0; p < polygons_.polygonCount(); ++p) {
      if (!takeAsIs(p)) carry(p);
    }
    for (std::size_t t = 0; t < out_.map.cornerUv.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) out_.map.cornerUv[t][k] = cornerUv(corner(t, k));
    }
    dropUnused();
    return std::move(out_);
  }

 private:
  int corner(std::size_t t, std::size_t k) const {
    return corners_.empty() ? static_cast<int>(3 * t + k) : corners_[t][k];
  }
  int& cornerUv(int c) { return out_.cornerUv[static_cast<std::size_t>(c)]; }
  Vec2 uv(int i) const { return out_.map.uv[static_cast<std::size_t>(i)]; }
  const std::array<int, 3>& given(int t) const {
    return out_.map.cornerUv[static_cast<std::size_t>(t)];
  }

  /// Keeps a polygon each of whose corners already has a single uv; false for other polygons.
  bool takeAsIs(int p) {
    bool isWhole = true;
    for (int t = polygons_.firstTriangle(p); t < polygons_.firstTriangle(p + 1); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        int& slot = cornerUv(corner(static_cast<std::size_t>(t), k));
        if (slot >= 0 && slot != given(t)[k]) isWhole = false;
        if (slot < 0) slot = given(t)[k];
      }
    }
    return isWhole;
  }

  bool isFollower(int t) const {
    return !partOf_.empty() && partOf_[static_cast<std::size_t>(t)] < 0;
  }

  /// Starts with the polygon's first triangle that follows no other and moves its neighbours into that chart;
  /// followers are placed once no other triangle can be.
  void carry(int p) {
    ++out_.carriedPolygons;
    const int first = polygons_.firstTriangle(p), last = polygons_.firstTriangle(p + 1);
    for (std::uint32_t c = polygons_.start[static_cast<std::size_t>(p)];
         c < polygons_.start[static_cast<std::size_t>(p) + 1]; ++c) {
      out_.cornerUv[c] = -1;
    }
    std::vector<int> waiting;
    for (int t = first; t < last; ++t) waiting.push_back(t);
    const auto begin = std::stable_partition(waiting.begin(), waiting.end(),
                                             [&](int t) { return !isFollower(t); });
    for (std::size_t k = 0; k < 3; ++k)
      cornerUv(corner(static_cast<std::size_t>(waiting[0]), k)) = given(waiting[0])[k];
    std::vector<int> followers(begin, waiting.end());
    waiting.erase(begin, waiting.end());
    if (waiting.empty()) std::swap(waiting, followers);
    waiting.erase(waiting.begin());
    while (!waiting.empty() || !followers.empty()) {
      if (carryAny(waiting)) continue;
      if (!carryOne(followers)) break;  // cannot happen: ears form a tree
    }
  }

  bool carryAny(std::vector<int>& waiting) {
    const auto done = std::stable_partition(waiting.begin(), waiting.end(),
                                            [&](int t) { return !carryTriangle(t); });
    const bool isAny = done != waiting.end();
    waiting.erase(done, waiting.end());
    return isAny;
  }
  bool carryOne(std::vector<int>& waiting) {
    const auto one =
        std::find_if(waiting.begin(), waiting.end(), [&](int t) { return carryTriangle(t); });
    if (one == waiting.end()) return false;
    waiting.erase(one);
    return true;
  }

  /// Places triangle t if two of its corners have been placed.
  bool carryTriangle(int t) {
    std::size_t open = 3;
    int openCount = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      if (cornerUv(corner(static_cast<std::size_t>(t), k)) < 0) {
        open = k;
        ++openCount;
      }
    }
    if (openCount != 1) return openCount == 0;
    const std::size_t k0 = (open + 1) % 3, k1 = (open + 2) % 3;
    const int c = corner(static_cast<std::size_t>(t), open);
    const int a0 = cornerUv(corner(static_cast<std::size_t>(t), k0));
    const int a1 = cornerUv(corner(static_cast<std::size_t>(t), k1));
    if (a0 == given(t)[k0] && a1 == given(t)[k1]) {
      cornerUv(c) = given(t)[open];
      return true;
    }
    const Complex b0 = toComplex(uv(given(t)[k0])), b1 = toComplex(uv(given(t)[k1]));
    const Complex motion =
        snapped(portable::divide(toComplex(uv(a1)) - toComplex(uv(a0)), b1 - b0));
    const Complex z = toComplex(uv(a0)) + motion * (toComplex(uv(given(t)[open])) - b0);
    cornerUv(c) = copyAt(polygons_.cornerVertex[static_cast<std::size_t>(c)], {z.real(), z.imag()});
    return true;
  }

  static Complex snapped(Complex ratio) {
    for (int quarter = 0; quarter < 4; ++quarter) {
      if (portable::abs(ratio - rotation(quarter, 4)) < kQuarterTurn) return rotation(quarter, 4);
    }
    return ratio;
  }

  /// A copy of vertex v at this place: an existing one if there is one, so that charts stay connected.
  int copyAt(int v, const Vec2& place) {
    if (copies_.empty()) collectCopies();
    std::vector<int>& list = copies_[v];
    for (int i : list) {
      const Vec2 p = uv(i);
      if (std::max(std::abs(p[0] - place[0]), std::abs(p[1] - place[1])) <= kSameCopy * largest_) {
        return i;
      }
    }
    list.push_back(static_cast<int>(out_.map.uv.size()));
    out_.map.uv.push_back(place);
    return list.back();
  }

  void collectCopies() {
    for (std::size_t t = 0; t < out_.map.cornerUv.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int v = polygons_.cornerVertex[static_cast<std::size_t>(corner(t, k))];
        std::vector<int>& list = copies_[v];
        const int i = out_.map.cornerUv[t][k];
        if (std::find(list.begin(), list.end(), i) == list.end()) list.push_back(i);
      }
    }
  }

  void dropUnused() {
    std::vector<int> renamed(out_.map.uv.size(), -1);
    for (int i : out_.cornerUv) renamed[static_cast<std::size_t>(i)] = 0;
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < renamed.size(); ++i) {
      if (renamed[i] < 0) continue;
      renamed[i] = static_cast<int>(kept.size());
      kept.push_back(out_.map.uv[i]);
    }
    for (int& i : out_.cornerUv) i = renamed[static_cast<std::size_t>(i)];
    for (auto& t : out_.map.cornerUv) {
      for (int& i : t) i = renamed[static_cast<std::size_t>(i)];
    }
    out_.map.uv = std::move(kept);
  }

  const PolygonMesh& polygons_;
  const TriangleCorners& corners_;
  const std::vector<int>& partOf_;
  PolygonUv out_;
  double largest_ = 0;
  std::unordered_map<int, std::vector<int>> copies_;
};

}  // namespace

PolygonUv keepPolygonsWhole(const PolygonMesh& polygons, const TriangleCorners& corners,
                            const UvMap& map, const std::vector<int>& partOf) {
  return PolygonKeeper(polygons, corners, map, partOf).keep();
}

}  // namespace hgp::io
