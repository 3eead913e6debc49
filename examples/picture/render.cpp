#include "render.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "../models/vectors.h"

namespace hgp::picture {
namespace {

using namespace hgp::models;

constexpr int kSamples = 3;           // per pixel and direction
constexpr double kEyeDistance = 4.5;  // in radii of the model
const Colour kPaper = {1, 1, 1};

/// The projection of a point: x, y in samples, and 1/distance, which is linear on the screen.
struct Seen {
  double x = 0, y = 0, nearness = 0;
};

class View {
 public:
  View(const Scene& scene, const Camera& camera, int width, int height)
      : isFlat_(scene.isFlat), width_(width * kSamples), height_(height * kSamples) {
    const double a = camera.turn * std::numbers::pi / 180, b = camera.lift * std::numbers::pi / 180;
    if (!isFlat_) {
      right_ = {std::cos(a), 0, -std::sin(a)};
      toEye_ = {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
      up_ = cross(toEye_, right_);
    }
    frame(scene.mesh.positions, camera);
  }

  Seen see(const Vec3& p) const {
    const Vec3 d = (1 / radius_) * (p - center_);
    const double nearness = isFlat_ ? 1 / kEyeDistance : 1 / (kEyeDistance - dot(d, toEye_));
    const double scale = scale_ * kEyeDistance * nearness;
    return {middleX_ + scale * dot(d, right_), middleY_ - scale * dot(d, up_), nearness};
  }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Brightness of a surface with this normal, by which stored colours are multiplied: the page's studio, a lamp above
  /// the viewer's right shoulder, weak ones from the left and from behind, and light from everywhere.
  double light(const Vec3& normal) const {
    if (isFlat_) return 1;
    const auto lamp = [&](double right, double up, double toEye) {
      return std::max(dot(normal, unit(right * right_ + up * up_ + toEye * toEye_)), 0.0);
    };
    const double sum = 0.34 + 0.07 * dot(normal, up_) + 0.62 * lamp(0.6, 0.7, 0.6) +
                       0.2 * lamp(-0.55, 0.05, 0.85) + 0.15 * lamp(-0.35, 0.55, -0.85);
    return std::pow(sum, 1 / 2.2);
  }

 private:
  /// Sets centre and scale so that the picture of all points fills the frame.
  void frame(const std::vector<Vec3>& points, const Camera& camera) {
    Vec3 low = points[0], high = points[0];
    for (const Vec3& p : points) {
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    }
    center_ = 0.5 * (low + high);
    radius_ = 0;
    for (const Vec3& p : points) radius_ = std::max(radius_, norm(p - center_));
    double left = 1e30, right = -1e30, top = 1e30, bottom = -1e30;
    for (const Vec3& p : points) {
      const Seen s = see(p);
      left = std::min(left, s.x);
      right = std::max(right, s.x);
      top = std::min(top, s.y);
      bottom = std::max(bottom, s.y);
    }
    scale_ = 0.93 * camera.zoom * std::min(width_ / (right - left), height_ / (bottom - top));
    // First computed with scale 1 and the centre at 0.
    Seen middle{(left + right) / 2, (top + bottom) / 2, 0};
    const double scale = std::exchange(scale_, 1.0);
    if (camera.focus) middle = see(*camera.focus);
    scale_ = scale;
    middleX_ = width_ / 2.0 - scale_ * middle.x;
    middleY_ = height_ / 2.0 - scale_ * middle.y;
  }

  bool isFlat_;
  int width_, height_;
  Vec3 right_{1, 0, 0}, up_{0, 1, 0}, toEye_{0, 0, 1}, center_{};
  double radius_ = 1, scale_ = 1, middleX_ = 0, middleY_ = 0;
};

/// At every corner, the area-weighted mean of the normals at its vertex that differ from that of its triangle by less than
/// 40°, as on the page: smooth but for creases.
std::vector<std::array<Vec3, 3>> cornerNormals(const MeshData& mesh) {
  const double least = std::cos(40 * std::numbers::pi / 180);
  std::vector<std::vector<int>> at(mesh.positions.size());
  std::vector<Vec3> areas;
  for (const auto& t : mesh.triangles) {
    for (int v : t) at[v].push_back(static_cast<int>(areas.size()));
    const Vec3& p = mesh.positions[t[0]];
    areas.push_back(cross(mesh.positions[t[1]] - p, mesh.positions[t[2]] - p));
  }
  std::vector<std::array<Vec3, 3>> normals(areas.size());
  for (std::size_t f = 0; f < areas.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      Vec3 sum{0, 0, 0};
      for (int g : at[mesh.triangles[f][k]])
        if (dot(areas[f], areas[g]) >= least * norm(areas[f]) * norm(areas[g]))
          sum = sum + areas[g];
      normals[f][k] = norm(sum) > 0 ? unit(sum) : sum;
    }
  }
  return normals;
}

class Canvas {
 public:
  Canvas(const Scene& scene, const Camera& camera, int width, int height)
      : scene_(scene),
        view_(scene, camera, width, height),
        image_(view_.width(), view_.height(), kPaper),
        nearness_(image_.pixels.size(), 0.0),
        normals_(cornerNormals(scene.mesh)) {}

  Image paint() {
    for (std::size_t f = 0; f < scene_.mesh.triangles.size(); ++f) fill(static_cast<int>(f));
    for (const Line& line : scene_.lines) stroke(line);
    for (const Dot& dot : scene_.dots) {
      disc(view_.see(dot.at), scene_.dotRadius + 1, {0.1, 0.1, 0.1}, 0.03);
      disc(view_.see(dot.at), scene_.dotRadius, dot.colour, 0.031);
    }
    return shrink(image_, kSamples);
  }

 private:
  void fill(int f) {
    const auto& t = scene_.mesh.triangles[f];
    std::array<Seen, 3> s;
    for (int i = 0; i < 3; ++i) s[i] = view_.see(scene_.mesh.positions[t[i]]);
    const double area =
        (s[1].x - s[0].x) * (s[2].y - s[0].y) - (s[2].x - s[0].x) * (s[1].y - s[0].y);
    if (area == 0) return;
    const auto [left, right] = std::minmax({s[0].x, s[1].x, s[2].x});
    const auto [top, bottom] = std::minmax({s[0].y, s[1].y, s[2].y});
    const int x0 = std::max(0, static_cast<int>(left)), y0 = std::max(0, static_cast<int>(top));
    const int x1 = std::min(image_.width - 1, static_cast<int>(right));
    const int y1 = std::min(image_.height - 1, static_cast<int>(bottom));
    const double footprint = footprintOf(f, area);
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) {
        Vec3 w;  // barycentric coordinates on the screen
        for (int i = 0; i < 3; ++i) {
          const Seen &a = s[(i + 1) % 3], &b = s[(i + 2) % 3];
          w[i] = ((b.x - a.x) * (y + 0.5 - a.y) - (x + 0.5 - a.x) * (b.y - a.y)) / area;
        }
        if (std::min({w[0], w[1], w[2]}) >= 0) shade(f, s, w, x, y, footprint, area < 0);
      }
    }
  }

  /// uv length that one pixel covers, from the ratio of areas.
  double footprintOf(int f, double area) const {
    if (scene_.uv.empty()) return 0;
    const auto& uv = scene_.uv[f];
    const double uvArea = (uv[1][0] - uv[0][0]) * (uv[2][1] - uv[0][1]) -
                          (uv[2][0] - uv[0][0]) * (uv[1][1] - uv[0][1]);
    return std::sqrt(std::abs(uvArea / area)) * kSamples;
  }

  void shade(int f, const std::array<Seen, 3>& s, const Vec3& w, int x, int y, double footprint,
             bool isFront) {
    const double nearness = w[0] * s[0].nearness + w[1] * s[1].nearness + w[2] * s[2].nearness;
    double& depth = nearness_[static_cast<std::size_t>(y) * image_.width + x];
    if (nearness <= depth) return;
    depth = nearness;
    Spot spot;
    spot.face = f;
    spot.footprint = footprint;
    Vec3 normal{0, 0, 0};
    for (int i = 0; i < 3; ++i) {
      spot.weights[i] = w[i] * s[i].nearness / nearness;
      normal = normal + spot.weights[i] * normals_[f][i];
      if (scene_.uv.empty()) continue;
      spot.uv[0] += spot.weights[i] * scene_.uv[f][i][0];
      spot.uv[1] += spot.weights[i] * scene_.uv[f][i][1];
    }
    // The inside of an open surface is grey.
    const Colour colour = isFront || scene_.isFlat ? scene_.paint(spot) : Colour{0.62, 0.62, 0.66};
    if (!isFront) normal = -1 * normal;
    image_.at(x, y) = mix({0, 0, 0}, colour, std::min(view_.light(normal), 1.0));
  }

  /// Draws a disc in front of everything at almost the same depth.
  void disc(const Seen& s, double radius, const Colour& colour, double lead) {
    const double r = radius * kSamples;
    for (int y = std::max(0, static_cast<int>(s.y - r));
         y <= std::min(image_.height - 1.0, s.y + r); ++y) {
      for (int x = std::max(0, static_cast<int>(s.x - r));
           x <= std::min(image_.width - 1.0, s.x + r); ++x) {
        if (std::hypot(x + 0.5 - s.x, y + 0.5 - s.y) > r) continue;
        double& depth = nearness_[static_cast<std::size_t>(y) * image_.width + x];
        const double nearness = s.nearness * (1 + lead);
        if (nearness < depth) continue;
        depth = nearness;
        image_.at(x, y) = colour;
      }
    }
  }

  void stroke(const Line& line) {
    const Seen a = view_.see(line.from), b = view_.see(line.to);
    const int steps = 1 + static_cast<int>(std::hypot(b.x - a.x, b.y - a.y) / kSamples * 2);
    for (int i = 0; i <= steps; ++i) {
      const double t = double(i) / steps;
      disc({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
            a.nearness + t * (b.nearness - a.nearness)},
           scene_.lineWidth / 2, line.colour, 0.01);
    }
  }

  const Scene& scene_;
  View view_;
  Image image_;
  std::vector<double> nearness_;
  std::vector<std::array<Vec3, 3>> normals_;
};

}  // namespace

Image render(const Scene& scene, const Camera& camera, int width, int height) {
  return Canvas(scene, camera, width, height).paint();
}

}  // namespace hgp::picture
