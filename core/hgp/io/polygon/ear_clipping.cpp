#include "hgp/io/polygon/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "hgp/mesh/vectors.h"

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

/// Scores that differ by less are equal: coordinates have six digits in many files.
constexpr double kSameScore = 1e-4;

/// Of the four corners, those for which `value` is largest; the comparison is relative to `size`.
void keepLargest(std::vector<int>& candidates, double size,
                 const std::function<double(int)>& value) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const int i : candidates) largest = std::max(largest, value(i));
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](int i) { return value(i) < largest - kSameScore * size; }),
                   candidates.end());
}

/// The first of two corners that a diagonal joins where both diagonals of a quadrilateral are equally good. No answer depends
/// on where the list of corners starts or on its direction. @param q  relative to the centre of the mesh
int cornerOfDiagonal(const std::array<Vec3, 4>& q) {
  const auto at = [&](int i) -> const Vec3& { return q[static_cast<std::size_t>(i)]; };
  const double size = norm(subtract(at(2), at(0))) + norm(subtract(at(3), at(1)));
  std::vector<int> candidates{0, 1, 2, 3};
  keepLargest(candidates, size, [&](int i) { return norm(at(i)); });
  for (std::size_t k = 0; k < 3; ++k)
    keepLargest(candidates, size, [&](int i) { return std::abs(at(i)[k]); });
  for (std::size_t k = 0; k < 3; ++k)
    keepLargest(candidates, size, [&](int i) { return at(i)[k]; });
  return candidates.front();
}

class EarClipper {
 public:
  EarClipper(const std::vector<Vec3>& polygon, const Vec3& centre, std::int64_t& tests,
             const DiagonalCosts* costs)
      : polygon_(polygon), centre_(centre), flat_(flatten(polygon)), tests_(tests), costs_(costs) {
    for (std::size_t i = 0; i < polygon.size(); ++i) ring_.push_back(static_cast<int>(i));
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

  /// The ear that leaves the quadrilateral of the ring's four corners with the diagonal that is taken of two equally good ones.
  std::size_t earOfEquals() const {
    std::array<Vec3, 4> q;
    for (std::size_t i = 0; i < 4; ++i)
      q[i] = subtract(polygon_[static_cast<std::size_t>(ring_[i])], centre_);
    return static_cast<std::size_t>(cornerOfDiagonal(q) + 1) % 4;
  }

  /// The valid ear of best quality; for a quadrilateral, the remaining triangle counts as well.
  std::size_t bestEar() {
    std::size_t best = 0;
    double bestScore = -std::numeric_limits<double>::infinity();
    std::array<double, 2> scores{};  // of a quadrilateral's diagonals
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
      scores[i % 2] = score;
      if (score > bestScore) {
        best = i;
        bestScore = score;
      }
    }
    const bool isEqual = std::abs(scores[0] - scores[1]) < kSameScore;
    return ring_.size() == 4 && isEqual ? earOfEquals() : best;
  }

  const std::vector<Vec3>& polygon_;
  const Vec3 centre_;
  const std::vector<Vec2> flat_;
  std::int64_t& tests_;
  const DiagonalCosts* costs_;
  std::vector<int> ring_;
};

}  // namespace

std::vector<std::array<int, 3>> clipEars(const std::vector<Vec3>& polygon, const Vec3& centre,
                                         std::int64_t& tests, const DiagonalCosts* costs) {
  return EarClipper(polygon, centre, tests, costs).clip();
}

}  // namespace hgp::io
