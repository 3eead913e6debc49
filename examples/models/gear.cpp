// A part as it comes from a CAD program and a remesher: flat and cylindrical faces that meet in sharp edges.

#include <array>
#include <cmath>
#include <numbers>

#include "models.h"

namespace hgp::models {
namespace {

/// A point of the teeth's outline or of the bore, in the plane.
using Point = std::array<double, 2>;

/// Rows of vertices around the axis, joined one to the next.
class Rows {
 public:
  explicit Rows(int around) : around_(around) {}

  void add(const std::vector<Point>& row, double height) {
    for (const Point& p : row) mesh_.positions.push_back({p[0], height, p[1]});
  }
  /// Joins every row with the next, and the last with the first.
  MeshData closed() {
    const int rows = static_cast<int>(mesh_.positions.size()) / around_;
    for (int r = 0; r < rows; ++r) {
      for (int i = 0; i < around_; ++i) {
        const int a = at(r, i), b = at(r, i + 1);
        const int c = at((r + 1) % rows, i + 1), d = at((r + 1) % rows, i);
        // Diagonals alternate, so that no direction is preferred.
        if ((i + r) % 2 == 0) {
          mesh_.triangles.push_back({a, b, c});
          mesh_.triangles.push_back({a, c, d});
        } else {
          mesh_.triangles.push_back({a, b, d});
          mesh_.triangles.push_back({b, c, d});
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  int at(int row, int i) const { return row * around_ + i % around_; }

  int around_;
  MeshData mesh_;
};

/// Teeth with straight flanks; `steps` vertices along each of their four sides.
std::vector<Point> outline(int teeth, int steps) {
  constexpr double kRoot = 0.78, kTip = 1.0;
  // Where a flank begins, the tip, the other flank, and the root after it, as shares of the angle of a tooth.
  constexpr std::array<double, 4> kShares = {0.2, 0.35, 0.65, 0.8};
  const auto corner = [&](std::size_t side, int tooth) -> Point {
    const double angle = 2 * std::numbers::pi * (tooth + kShares[side]) / teeth;
    const double radius = side == 1 || side == 2 ? kTip : kRoot;
    return {radius * std::cos(angle), radius * std::sin(angle)};
  };
  std::vector<Point> out;
  for (int tooth = 0; tooth < teeth; ++tooth) {
    for (std::size_t side = 0; side < 4; ++side) {
      const Point a = corner(side, tooth);
      const Point b = side < 3 ? corner(side + 1, tooth) : corner(0, tooth + 1);
      for (int i = 0; i < steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        out.push_back({a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])});
      }
    }
  }
  return out;
}

std::vector<Point> bore(const std::vector<Point>& around, double radius) {
  std::vector<Point> out;
  for (const Point& p : around) {
    const double length = std::hypot(p[0], p[1]);
    out.push_back({radius * p[0] / length, radius * p[1] / length});
  }
  return out;
}

std::vector<Point> between(const std::vector<Point>& a, const std::vector<Point>& b, double t) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < a.size(); ++i)
    out.push_back({a[i][0] + t * (b[i][0] - a[i][0]), a[i][1] + t * (b[i][1] - a[i][1])});
  return out;
}

}  // namespace

MeshData gear(int teeth, int steps) {
  constexpr double kHeight = 0.22;
  const std::vector<Point> outside = outline(teeth, steps), inside = bore(outside, 0.34);
  const int flat = 4 * steps, tall = 2 * steps;
  Rows rows(static_cast<int>(outside.size()));
  // From the upper edge of the bore outwards, down the teeth, back below, and up the bore.
  for (int r = 0; r < flat; ++r)
    rows.add(between(inside, outside, static_cast<double>(r) / flat), kHeight);
  for (int r = 0; r < tall; ++r) rows.add(outside, kHeight - 2 * kHeight * r / tall);
  for (int r = 0; r < flat; ++r)
    rows.add(between(outside, inside, static_cast<double>(r) / flat), -kHeight);
  for (int r = 0; r < tall; ++r) rows.add(inside, -kHeight + 2 * kHeight * r / tall);
  return rows.closed();
}

}  // namespace hgp::models
