#include "hgp/verify/face_values.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/verify/orientation.h"

namespace hgp {
namespace {

/// One triangle's derivative in the plane of the surface.
struct Derivative {
  double stretch = 1, area = 0;
};

Derivative derivativeOf(const std::array<Vec3, 3>& p, const std::array<Vec2, 3>& uv) {
  Vec3 e, f;
  for (std::size_t n = 0; n < 3; ++n) {
    e[n] = p[1][n] - p[0][n];
    f[n] = p[2][n] - p[0][n];
  }
  const auto dot = [](const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const Vec3 normal{e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2],
                    e[0] * f[1] - e[1] * f[0]};
  const double length = std::sqrt(dot(e, e)), twice = std::sqrt(dot(normal, normal));
  if (!(twice > 0) || !std::isfinite(twice)) return {};
  const double x = dot(e, f) / length, y = twice / length;
  const Vec2 du{uv[1][0] - uv[0][0], uv[1][1] - uv[0][1]};
  const Vec2 dv{uv[2][0] - uv[0][0], uv[2][1] - uv[0][1]};
  const Vec2 fx{du[0] / length, du[1] / length};
  const Vec2 fy{(dv[0] - x * fx[0]) / y, (dv[1] - x * fx[1]) / y};
  const double similar = 0.5 * portable::hypot(fx[0] + fy[1], fx[1] - fy[0]);
  const double anti = 0.5 * portable::hypot(fx[0] - fy[1], fx[1] + fy[0]);
  const double small = std::fabs(similar - anti), large = similar + anti;
  return {large > 0 ? large / std::max(small, 1e-12 * large) : 1, twice / 2};
}

/// log₂ of every ratio, less the mean over its component weighted by area; 0 where there is no ratio.
std::vector<float> logAreas(const std::vector<double>& ratio, const std::vector<double>& area,
                            const std::vector<int>& componentOf) {
  struct LogSum {
    double area = 0, log = 0;
  };
  std::vector<LogSum> sums(1);
  const auto sumOf = [&](std::size_t t) -> LogSum& {
    const auto p = componentOf.empty() ? 0 : static_cast<std::size_t>(componentOf[t] + 1);
    if (p >= sums.size()) sums.resize(p + 1);
    return sums[p];
  };
  const auto isMeasured = [&](std::size_t t) { return ratio[t] > 0 && std::isfinite(ratio[t]); };
  for (std::size_t t = 0; t < ratio.size(); ++t) {
    if (!isMeasured(t)) continue;
    LogSum& sum = sumOf(t);
    sum.area += area[t];
    sum.log += area[t] * portable::log2(ratio[t]);
  }
  std::vector<float> out;
  out.reserve(ratio.size());
  for (std::size_t t = 0; t < ratio.size(); ++t) {
    const LogSum& sum = sumOf(t);
    out.push_back(isMeasured(t) ? static_cast<float>(portable::log2(ratio[t]) - sum.log / sum.area)
                                : 0.0F);
  }
  return out;
}

}  // namespace

FaceValues measureFaces(const MeshData& mesh, const UvMap& map,
                        const std::vector<int>& componentOf) {
  FaceValues out;
  const std::size_t count = mesh.triangles.size();
  std::vector<double> ratio(count, 0.0), area(count, 0.0);  // 0: no area on the surface
  out.stretch.reserve(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
      uv[k] = map.uv[static_cast<std::size_t>(map.cornerUv[t][k])];
    }
    const Derivative d = derivativeOf(p, uv);
    const double uvArea = std::fabs(exactTwiceArea(uv[0], uv[1], uv[2])) / 2;
    if (orientationSign(uv[0], uv[1], uv[2]) <= 0) out.notPositive.push_back(static_cast<int>(t));
    out.stretch.push_back(static_cast<float>(d.stretch));
    out.surfaceArea += d.area;
    out.uvArea += uvArea;
    ratio[t] = d.area > 0 ? uvArea / d.area : 0;
    area[t] = d.area;
  }
  out.logArea = logAreas(ratio, area, componentOf);
  return out;
}

}  // namespace hgp
