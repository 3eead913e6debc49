#include "hgp/io/uv_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "hgp/io/document.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

constexpr double kDrawingSize = 1000;

/// Transforms uv to coordinates of the drawing, whose y points down.
class Drawing {
 public:
  explicit Drawing(const std::vector<Vec2>& uv) : uv_(uv) {
    constexpr double kFar = std::numeric_limits<double>::max();
    Vec2 low{kFar, kFar}, high{-kFar, -kFar};
    for (const Vec2& p : uv) {
      for (std::size_t k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    }
    if (uv.empty()) low = high = {0, 0};
    corner_ = {low[0], high[1]};
    const double extent = std::max(high[0] - low[0], high[1] - low[1]);
    scale_ = extent > 0 ? kDrawingSize / extent : 1;
    width_ = (high[0] - low[0]) * scale_;
    height_ = (high[1] - low[1]) * scale_;
  }

  std::string viewBox() const {
    std::string out = "-5 -5";
    number(out += ' ', width_ + 10);
    number(out += ' ', height_ + 10);
    return out;
  }

  void line(std::string& out, const UvEdge& edge) const {
    point(out += 'M', edge[0]);
    point(out += 'L', edge[1]);
  }

 private:
  void point(std::string& out, int i) const {
    const Vec2& p = uv_[static_cast<std::size_t>(i)];
    number(out, (p[0] - corner_[0]) * scale_);
    number(out += ' ', (corner_[1] - p[1]) * scale_);
  }
  /// Writes x rounded to hundredths, without printf, which is too slow for millions of numbers.
  static void number(std::string& out, double x) {
    const auto hundredths = static_cast<std::int64_t>(std::llround(100 * std::max(x, 0.0)));
    text::appendInt(out, hundredths / 100);
    const auto rest = static_cast<int>(hundredths % 100);
    if (rest == 0) return;
    out += '.';
    out += static_cast<char>('0' + rest / 10);
    if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
  }

  const std::vector<Vec2>& uv_;
  Vec2 corner_{0, 0};
  double scale_ = 1, width_ = 0, height_ = 0;
};

std::vector<UvEdge> edgesOf(const UvMap& map) {
  std::vector<UvEdge> edges;
  edges.reserve(3 * map.cornerUv.size());
  for (const auto& corners : map.cornerUv) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners[k], b = corners[(k + 1) % 3];
      if (a >= 0 && b >= 0) edges.push_back({std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace

Bytes uvLayoutSvg(const UvMap& map, const std::vector<UvEdge>& seams) {
  const Drawing drawing(map.uv);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"" + drawing.viewBox() +
                    "\" fill=\"none\" stroke-linecap=\"round\"><path stroke=\"#55606c\" "
                    "stroke-width=\".5\" d=\"";
  for (const UvEdge& edge : edgesOf(map)) drawing.line(out, edge);
  out += "\"/><path stroke=\"#b3261e\" stroke-width=\"2\" d=\"";
  for (const UvEdge& seam : seams) drawing.line(out, seam);
  return asBytes(out + "\"/></svg>\n");
}

Bytes flatObj(const UvMap& map, const std::string& generator) {
  MeshData flat;
  flat.positions.reserve(map.uv.size());
  for (const Vec2& p : map.uv) flat.positions.push_back({p[0], p[1], 0});
  flat.triangles = map.cornerUv;
  return writePlainObj(flat, map, generator.empty() ? "" : generator + ": the map laid flat");
}

}  // namespace hgp::io
