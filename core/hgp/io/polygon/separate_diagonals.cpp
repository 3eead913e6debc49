#include "hgp/io/polygon/separate_diagonals.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "hgp/io/polygon/ear_clipping.h"
#include "hgp/io/weld.h"
#include "hgp/mesh/finite.h"

namespace hgp::io {
namespace {

constexpr int kMaxCorners = 64;  // as far as clipEars compares all ears
// A polygon whose other triangles would be inverted waits for its neighbour in the first passes, and gives way itself
// in the others.
constexpr int kPatientPasses = 3, kDiagonalPasses = 6;
constexpr double kCostOfSide = 4, kCostOfDiagonal = 2, kPatient = 3, kForced = 1;

using Edge = std::pair<int, int>;  // smaller vertex first

std::uint64_t keyOf(const Edge& e) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(e.first)) << 32 |
         static_cast<std::uint32_t>(e.second);
}

class Separator {
 public:
  Separator(const PolygonMesh& polygons, TriangleCorners& corners, std::int64_t& tests)
      : polygons_(polygons),
        corners_(corners),
        tests_(tests),
        centre_(centreOf(finiteBoxOf(polygons.positions))),
        vertex_(weldExact(polygons.positions).welded) {}

  void run() {
    findTwins();
    copyTwins();
    for (int pass = 0; pass < kDiagonalPasses && tests_ <= kMaxEarTests; ++pass) {
      const std::vector<int> found = conflicts();
      if (found.empty()) return;
      countUses(found);
      bool isChanged = false;
      for (const int p : found)
        isChanged = clipAgain(p, pass < kPatientPasses ? kPatient : kForced) || isChanged;
      copyTwins();
      if (!isChanged && pass >= kPatientPasses) return;
    }
  }

 private:
  struct Uses {
    int sides = 0, diagonals = 0;
  };

  int first(int p) const { return static_cast<int>(polygons_.start[static_cast<std::size_t>(p)]); }
  int size(int p) const { return first(p + 1) - first(p); }
  int vertexAt(int corner) const {
    return vertex_[static_cast<std::size_t>(
        polygons_.cornerVertex[static_cast<std::size_t>(corner)])];
  }
  Edge edge(int cornerA, int cornerB) const {
    return std::minmax({vertexAt(cornerA), vertexAt(cornerB)});
  }

  template <typename Visit>
  void forSides(int p, const Visit& visit) const {
    for (int i = 0; i < size(p); ++i) visit(edge(first(p) + i, first(p) + (i + 1) % size(p)));
  }

  /// Each diagonal lies in two triangles, in both directions.
  template <typename Visit>
  void forDiagonals(int p, const Visit& visit) const {
    if (size(p) == 3) return;
    for (int t = polygons_.firstTriangle(p); t < polygons_.firstTriangle(p + 1); ++t) {
      const auto& c = corners_[static_cast<std::size_t>(t)];
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = c[k], b = c[(k + 1) % 3];
        if (a < b && b - a != 1 && b - a != size(p) - 1) visit(edge(a, b));
      }
    }
  }

  std::uint64_t hashOf(int p) const {
    std::uint64_t sum = 0;
    for (int c = first(p); c < first(p + 1); ++c) {
      std::uint64_t h = (static_cast<std::uint64_t>(vertexAt(c)) + 1) * 0x9e3779b97f4a7c15u;
      sum += h ^ (h >> 29);
    }
    return sum;
  }

  /// The corner of p that corresponds to the first one of `other`, and the direction; {−1, 0}: other vertices.
  std::pair<int, int> match(int p, int other) const {
    const int n = size(p);
    for (int shift = 0; n == size(other) && shift < n; ++shift)
      for (const int direction : {1, -1}) {
        int i = 0;
        while (i < n &&
               vertexAt(first(other) + i) == vertexAt(first(p) + (shift + direction * i + n) % n))
          ++i;
        if (i == n) return {shift, direction};
      }
    return {-1, 0};
  }

  void findTwins() {
    std::vector<std::pair<std::uint64_t, int>> hashes;
    for (int p = 0; p < polygons_.polygonCount(); ++p)
      if (size(p) > 3 && size(p) <= kMaxCorners) hashes.emplace_back(hashOf(p), p);
    std::sort(hashes.begin(), hashes.end());
    isTwin_.assign(static_cast<std::size_t>(polygons_.polygonCount()), 0);
    std::size_t run = 0;
    for (std::size_t i = 1; i < hashes.size(); ++i) {
      if (hashes[i].first != hashes[run].first) {
        run = i;
        continue;
      }
      const int p = hashes[i].second, original = hashes[run].second;
      const auto [shift, direction] = match(p, original);
      if (shift < 0) continue;
      isTwin_[static_cast<std::size_t>(p)] = 1;
      twins_.push_back({p, original, shift, direction});
    }
  }

  void copyTwins() {
    for (const auto& [p, original, shift, direction] : twins_) {
      const int n = size(p), from = polygons_.firstTriangle(original);
      for (int t = 0; t < n - 2; ++t) {
        std::array<int, 3> c = corners_[static_cast<std::size_t>(from + t)];
        for (int& i : c) i = first(p) + (shift + direction * (i - first(original)) + n) % n;
        if (direction < 0) std::swap(c[1], c[2]);
        corners_[static_cast<std::size_t>(polygons_.firstTriangle(p) + t)] = c;
      }
    }
  }

  /// The polygons of which a diagonal joins vertices that are joined elsewhere, ascending.
  std::vector<int> conflicts() const {
    std::vector<int> start(vertex_.size() + 1, 0);
    const auto forAll = [&](const auto& visit) {
      for (int p = 0; p < polygons_.polygonCount(); ++p)
        if (!isTwin_[static_cast<std::size_t>(p)])
          forDiagonals(p, [&](const Edge& e) { visit(e, p); });
    };
    forAll([&](const Edge& e, int) { ++start[static_cast<std::size_t>(e.first) + 1]; });
    for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
    std::vector<std::pair<int, int>> ends(static_cast<std::size_t>(start.back()));
    std::vector<int> next(start.begin(), start.end() - 1);
    forAll([&](const Edge& e, int p) {
      ends[static_cast<std::size_t>(next[static_cast<std::size_t>(e.first)]++)] = {e.second, p};
    });
    const auto bucket = [&](int v) {
      return std::pair(ends.begin() + start[static_cast<std::size_t>(v)],
                       ends.begin() + start[static_cast<std::size_t>(v) + 1]);
    };
    std::vector<int> found;
    for (int v = 0; v < static_cast<int>(vertex_.size()); ++v) {
      const auto [begin, end] = bucket(v);
      std::sort(begin, end);
      for (auto i = begin; i != end && i + 1 != end; ++i)
        if (i->first == (i + 1)->first) found.insert(found.end(), {i->second, (i + 1)->second});
    }
    for (int p = 0; p < polygons_.polygonCount(); ++p)
      forSides(p, [&](const Edge& e) {
        const auto [begin, end] = bucket(e.first);
        for (auto i = std::lower_bound(begin, end, std::pair(e.second, -1));
             i != end && i->first == e.second; ++i)
          found.push_back(i->second);
      });
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    found.erase(
        std::remove_if(found.begin(), found.end(), [&](int p) { return size(p) > kMaxCorners; }),
        found.end());
    return found;
  }

  /// How many sides and diagonals there are of every diagonal that these polygons could have.
  void countUses(const std::vector<int>& found) {
    uses_.clear();
    std::vector<char> isNear(vertex_.size(), 0);
    for (const int p : found)
      for (int a = first(p); a < first(p + 1); ++a) {
        isNear[static_cast<std::size_t>(vertexAt(a))] = 1;
        for (int b = a + 2; b < first(p + 1); ++b) uses_.try_emplace(keyOf(edge(a, b)));
      }
    const auto count = [&](const Edge& e, int Uses::*kind) {
      if (!isNear[static_cast<std::size_t>(e.first)] || !isNear[static_cast<std::size_t>(e.second)])
        return;
      if (const auto it = uses_.find(keyOf(e)); it != uses_.end()) ++(it->second.*kind);
    };
    for (int p = 0; p < polygons_.polygonCount(); ++p) {
      forSides(p, [&](const Edge& e) { count(e, &Uses::sides); });
      if (!isTwin_[static_cast<std::size_t>(p)])
        forDiagonals(p, [&](const Edge& e) { count(e, &Uses::diagonals); });
    }
  }

  /// Whether the triangles of polygon p changed.
  bool clipAgain(int p, double ofInvalid) {
    forDiagonals(p, [&](const Edge& e) { --uses_[keyOf(e)].diagonals; });
    std::vector<Vec3> points;
    for (int c = first(p); c < first(p + 1); ++c)
      points.push_back(polygons_.positions[static_cast<std::size_t>(
          polygons_.cornerVertex[static_cast<std::size_t>(c)])]);
    const DiagonalCosts costs{[&](int a, int b) {
                                const Edge e = edge(first(p) + a, first(p) + b);
                                const Uses& uses = uses_[keyOf(e)];
                                if (e.first == e.second || uses.sides > 0) return kCostOfSide;
                                return uses.diagonals > 0 ? kCostOfDiagonal : 0.0;
                              },
                              ofInvalid};
    bool isChanged = false;
    auto at = static_cast<std::size_t>(polygons_.firstTriangle(p));
    for (auto t : clipEars(points, centre_, tests_, &costs)) {
      for (int& i : t) i += first(p);
      isChanged = isChanged || corners_[at] != t;
      corners_[at++] = t;
    }
    forDiagonals(p, [&](const Edge& e) { ++uses_[keyOf(e)].diagonals; });
    return isChanged;
  }

  struct Twin {
    int polygon, original, shift, direction;
  };

  const PolygonMesh& polygons_;
  TriangleCorners& corners_;
  std::int64_t& tests_;
  const Vec3 centre_;
  std::vector<int> vertex_;
  std::vector<char> isTwin_;
  std::vector<Twin> twins_;
  std::unordered_map<std::uint64_t, Uses> uses_;
};

}  // namespace

void separateDiagonals(const PolygonMesh& polygons, TriangleCorners& corners, std::int64_t& tests) {
  Separator(polygons, corners, tests).run();
}

}  // namespace hgp::io
