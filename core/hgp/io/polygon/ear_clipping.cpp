#include "hgp/io/polygon/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hgp::io {
namespace {

// Above this many corners any valid ear is taken: choosing the best takes cubic time.
constexpr std::size_t kMaxForBestEar = 64;

Vec2 minus(const Vec2& a, const Vec2& b) { return {a[0] - b[0], a[1] - b[1]}; }
double cross(const Vec2& a, const Vec2& b) { return a[0] * b[1] - a[1] * b[0]; }
double dot(const Vec2& a, const Vec2& b) { return a[0] * b[0] + a[1] * b[1]; }
double turn(const Vec2& a, const Vec2& b, const Vec2& c) { return cross(minus(b, a), minus(c, a)); }

Vec3 newellNormal(const std::vector<Vec3>& p) {
  Vec3 n{0, 0, 0};
  for (std::size_t i = 0; i < p.size(); ++i) {
    const Vec3& a = p[i];
    const Vec3& b = p[(i + 1) % p.size()];
    // Relative to the first corner, to avoid cancellation far from the origin.
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      n[k] += (a[u] - p[0][u]) * (b[v] - p[0][v]) - (a[v] - p[0][v]) * (b[u] - p[0][u]);
    }
  }
  return n;
}

/// Projects the polygon onto the plane of its normal; the result is counterclockwise.
std::vector<Vec2> flatten(const std::vector<Vec3>& p) {
  const Vec3 n = newellNormal(p);
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  const std::size_t axis = std::abs(n[0]) < std::abs(n[1])
                               ? (std::abs(n[0]) < std::abs(n[2]) ? 0 : 2)
                               : (std::abs(n[1]) < std::abs(n[2]) ? 1 : 2);
  Vec3 e{0, 0, 0};
  e[axis] = 1;
  // x = e × n, y = n × x, of equal length.
  const Vec3 m = length > 0 ? Vec3{n[0] / length, n[1] / length, n[2] / length} : Vec3{0, 0, 1};
  const Vec3 x{e[1] * m[2] - e[2] * m[1], e[2] * m[0] - e[0] * m[2], e[0] * m[1] - e[1] * m[0]};
  const Vec3 y{m[1] * x[2] - m[2] * x[1], m[2] * x[0] - m[0] * x[2], m[0] * x[1] - m[1] * x[0]};
  std::vector<Vec2> flat;
  flat.reserve(p.size());
  for (const Vec3& q : p) {
    const Vec3 d{q[0] - p[0][0], q[1] - p[0][1], q[2] - p[0][2]};
    flat.push_back(
        {d[0] * x[0] + d[1] * x[1] + d[2] * x[2], d[0] * y[0] + d[1] * y[1] + d[2] * y[2]});
  }
  return flat;
}

/// Sine of the smallest angle, by which ears are ranked; ≤ 0 for a reflex corner.
double earQuality(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double area = turn(a, b, c);
  const double ab = dot(minus(b, a), minus(b, a));
  const double bc = dot(minus(c, b), minus(c, b));
  const double ca = dot(minus(a, c), minus(a, c));
  const double longest = std::sqrt(std::max({ab * bc, bc * ca, ca * ab}));
  return longest > 0 ? area / longest : 0;
}

class EarClipper {
 public:
  EarClipper(const std::vector<Vec2>& flat, std::int64_t& tests, const DiagonalCosts* costs)
      : flat_(flat), tests_(tests), costs_(costs) {
    for (std::size_t i = 0; i < flat.size(); ++i) ring_.push_back(static_cast<int>(i));
  }

  std::vector<std::array<int, 3>> clip() {
    std::vector<std::array<int, 3>> triangles;
    std::size_t from = 0;
    while (ring_.size() > 3) {
      const std::size_t ear = ring_.size() > kMaxForBestEar ? firstEar(from) : bestEar();
      triangles.push_back(earAt(ear));
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
      from = (ear + 1) % ring_.size();
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
    return triangles;
  }

 private:
  const Vec2& at(int i) const { return flat_[static_cast<std::size_t>(i)]; }
  std::array<int, 3> earAt(std::size_t i) const {
    const std::size_t n = ring_.size();
    return {ring_[(i + n - 1) % n], ring_[i], ring_[(i + 1) % n]};
  }

  /// Whether no other corner lies inside the ear or on its new side.
  bool isEmpty(const std::array<int, 3>& ear) {
    const Vec2 &a = at(ear[0]), &b = at(ear[1]), &c = at(ear[2]);
    for (int i : ring_) {
      if (i == ear[0] || i == ear[1] || i == ear[2]) continue;
      ++tests_;
      const Vec2& p = at(i);
      if (p == a || p == b || p == c) continue;
      if (turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0) return false;
    }
    return true;
  }

  std::size_t firstEar(std::size_t from) {
    const std::size_t n = ring_.size();
    for (std::size_t step = 0; step < n; ++step) {
      const std::size_t i = (from + step) % n;
      const auto ear = earAt(i);
      if (turn(at(ear[0]), at(ear[1]), at(ear[2])) > 0 && isEmpty(ear)) return i;
      if (tests_ > kMaxEarTests) break;
    }
    return from % n;  // not a simple polygon: any choice that terminates
  }

  /// The valid ear of best quality; for a quadrilateral, the remaining triangle counts as well.
  std::size_t bestEar() {
    std::size_t best = 0;
    double bestScore = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const auto ear = earAt(i);
      double score = earQuality(at(ear[0]), at(ear[1]), at(ear[2]));
      if (ring_.size() == 4) {
        const int opposite = ring_[(i + 2) % 4];
        score = std::min(score, earQuality(at(ear[2]), at(opposite), at(ear[0])));
      } else if (score > 0 && (costs_ || score > bestScore) && !isEmpty(ear)) {
        score = -1;  // worse than any valid ear, but better than none
      }
      if (costs_) score -= costs_->of(ear[0], ear[2]) + (score > 0 ? 0 : costs_->ofInvalid);
      if (score > bestScore) {
        best = i;
        bestScore = score;
      }
    }
    return best;
  }

  const std::vector<Vec2>& flat_;
  std::int64_t& tests_;
  const DiagonalCosts* costs_;
  std::vector<int> ring_;
};

}  // namespace

std::vector<std::array<int, 3>> clipEars(const std::vector<Vec3>& polygon, std::int64_t& tests,
                                         const DiagonalCosts* costs) {
  return EarClipper(flatten(polygon), tests, costs).clip();
}

}  // namespace hgp::io
