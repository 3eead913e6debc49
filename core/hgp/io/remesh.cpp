#include "hgp/io/remesh.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/ids.h"
#include "hgp/base/stable_order.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {
namespace {

/// Per corner of the new polygons the number of its blend of values that triangles have at their corners.
std::vector<int> blendCorners(const Remesh& remesh, const std::vector<std::array<int, 3>>& corners,
                              BlendTable& table) {
  std::vector<int> out;
  out.reserve(remesh.at.size());
  for (const FacePoint& p : remesh.at)
    out.push_back(table.of(blendOf(corners[hgp::at(p.triangle)], p.weight)));
  return out;
}

/// The input's normals, and those of the shape at corners where it has none.
void takeNormals(const PlainSurface& surface, const Remesh& remesh, PolygonAttributes& out) {
  std::vector<std::array<int, 3>> given = surface.cornerNormal;
  for (std::array<int, 3>& corners : given)
    for (int& n : corners)
      if (n >= 0 && !(norm(surface.normals[hgp::at(n)]) > 0)) n = -1;
  BlendTable table;
  out.cornerNormal = blendCorners(remesh, given, table);
  std::vector<int> index, ofShape(remesh.normals.size(), -1);
  const auto add = [&](const Vec3& n) {
    out.normals.push_back(n);
    return static_cast<int>(out.normals.size()) - 1;
  };
  for (const Blend& blend : table.blends()) {
    const Vec3 n = blended(blend, surface.normals);
    const double length = norm(n);
    index.push_back(length > 0 ? add(scaled(n, 1 / length)) : -1);
  }
  for (std::size_t c = 0; c < out.cornerNormal.size(); ++c) {
    int& n = out.cornerNormal[c];
    if (n >= 0) n = index[hgp::at(n)];
    const auto v = hgp::at(remesh.polygons.cornerVertex[c]);
    if (n >= 0 || v >= ofShape.size()) continue;
    if (ofShape[v] < 0) ofShape[v] = add(remesh.normals[v]);
    n = ofShape[v];
  }
}

}  // namespace

Blend blendOf(const std::array<int, 3>& of, const std::array<double, 3>& weight) {
  Blend out;
  std::size_t count = 0;
  std::array<std::size_t, 3> order{0, 1, 2};
  sortThree(order, [&](std::size_t a, std::size_t b) { return of[a] < of[b]; });
  for (const std::size_t k : order) {
    if (!(weight[k] > 0)) continue;
    if (of[k] < 0) return {};
    if (count > 0 && out.of[count - 1] == of[k]) {
      out.weight[count - 1] += weight[k];
      continue;
    }
    out.of[count] = of[k];
    out.weight[count++] = weight[k];
  }
  if (count == 1) out.weight[0] = 1.0;
  return out;
}

int BlendTable::of(const Blend& blend) {
  if (blend.of[0] < 0) return -1;
  const auto [found, isNew] = found_.try_emplace(blend, static_cast<int>(blends_.size()));
  if (isNew) blends_.push_back(blend);
  return found->second;
}

PolygonAttributes attributesAt(const PlainSurface& surface, const UvMap* uv, bool areLinear,
                               const Remesh& remesh) {
  PolygonAttributes out;
  if (uv != nullptr) {
    BlendTable table;
    out.cornerUv = blendCorners(remesh, uv->cornerUv, table);
    for (const Blend& blend : table.blends()) out.uv.push_back(blended(blend, uv->uv));
  }
  if (surface.cornerNormal.empty()) {
    out.normals = remesh.normals;
    if (!out.normals.empty()) out.cornerNormal = remesh.polygons.cornerVertex;
  } else {
    takeNormals(surface, remesh, out);
  }
  if (!surface.colors.empty()) {
    std::vector<std::array<double, 4>> colors = surface.colors;
    const auto toSrgb = [](std::array<double, 4>& c) {
      for (std::size_t k = 0; k < 3; ++k) c[k] = srgbFromLinear(c[k]);
    };
    if (!areLinear) std::for_each(colors.begin(), colors.end(), toSrgb);
    out.colors.assign(remesh.polygons.positions.size(), {1, 1, 1, 1});
    for (std::size_t c = remesh.at.size(); c-- > 0;) {
      const FacePoint& p = remesh.at[c];
      out.colors[hgp::at(remesh.polygons.cornerVertex[c])] =
          blended(blendOf(surface.mesh.triangles[hgp::at(p.triangle)], p.weight), colors);
    }
    if (areLinear) std::for_each(out.colors.begin(), out.colors.end(), toSrgb);
  }
  if (!surface.triangleMaterial.empty()) {
    out.materials = surface.materials;
    out.libraries = surface.libraries;
    for (const int t : remesh.triangle)
      out.polygonMaterial.push_back(surface.triangleMaterial[hgp::at(t)]);
  }
  return out;
}

}  // namespace hgp::io
