// Files of polygons with attributes.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/io/remesh.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {
namespace {

using Attributes = PolygonAttributes;

int materialAt(const Attributes& a, std::size_t polygon) {
  return a.polygonMaterial.empty() ? -1 : a.polygonMaterial[polygon];
}

/// Polygons with one material follow one another, in the order of the first of each.
std::vector<std::size_t> byMaterial(const PolygonMesh& polygons, const Attributes& a) {
  return stableOrder(hgp::at(polygons.polygonCount()), [&](std::size_t x, std::size_t y) {
    return materialAt(a, x) < materialAt(a, y);
  });
}

void appendObjCorner(std::string& out, int vertex, int uv, int normal) {
  out += formatText(" %d", vertex + 1);
  if (uv >= 0) out += formatText("/%d", uv + 1);
  if (normal >= 0) out += formatText(uv >= 0 ? "/%d" : "//%d", normal + 1);
}

int cornerIndex(const std::vector<int>& list, std::size_t corner) {
  return list.empty() ? -1 : list[corner];
}

std::string oneLine(std::string name) {
  for (char& c : name)
    if (static_cast<unsigned char>(c) < ' ') c = '_';
  return name;
}

/// One normal per vertex: the mean of those of its corners, or the first of them where these cancel.
std::vector<Vec3> vertexNormals(const PolygonMesh& polygons, const Attributes& a) {
  std::vector<Vec3> out(polygons.positions.size(), Vec3{0, 0, 0});
  std::vector<int> first(out.size(), -1);
  std::vector<char> isOne(out.size(), 1);
  for (std::size_t c = 0; c < a.cornerNormal.size(); ++c) {
    const int n = a.cornerNormal[c];
    if (n < 0) continue;
    const auto v = hgp::at(polygons.cornerVertex[c]);
    out[v] = add(out[v], a.normals[hgp::at(n)]);
    isOne[v] = first[v] < 0 || (isOne[v] != 0 && first[v] == n) ? 1 : 0;
    if (first[v] < 0) first[v] = n;
  }
  for (std::size_t v = 0; v < out.size(); ++v) {
    const double length = norm(out[v]);
    if (first[v] < 0) continue;
    out[v] =
        isOne[v] != 0 || !(length > 0) ? a.normals[hgp::at(first[v])] : scaled(out[v], 1 / length);
  }
  return out;
}

int byteOf(double share) {
  return static_cast<int>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

}  // namespace

Bytes polygonsAsObj(const PolygonMesh& polygons, const Attributes& a, const std::string& comment) {
  std::string out = "# " + comment + "\n";
  for (const std::string& library : a.libraries) out += "mtllib " + oneLine(library) + "\n";
  for (std::size_t v = 0; v < polygons.positions.size(); ++v) {
    const Vec3& p = polygons.positions[v];
    out += formatText("v %.17g %.17g %.17g", p[0], p[1], p[2]);
    for (std::size_t k = 0; k < 3 && !a.colors.empty(); ++k)
      out += formatText(" %.9g", a.colors[v][k]);
    out += "\n";
  }
  for (const Vec2& p : a.uv) out += formatText("vt %.17g %.17g\n", p[0], p[1]);
  for (const Vec3& n : a.normals) out += formatText("vn %.9g %.9g %.9g\n", n[0], n[1], n[2]);
  int material = -1;
  for (const std::size_t p : byMaterial(polygons, a)) {
    if (materialAt(a, p) != material) {
      material = materialAt(a, p);
      out += "usemtl " + oneLine(a.materials[hgp::at(material)]) + "\n";
    }
    out += "f";
    for (std::size_t c = polygons.start[p]; c < polygons.start[p + 1]; ++c)
      appendObjCorner(out, polygons.cornerVertex[c], cornerIndex(a.cornerUv, c),
                      cornerIndex(a.cornerNormal, c));
    out += "\n";
  }
  return asBytes(out);
}

Bytes polygonsAsPly(const PolygonMesh& polygons, const Attributes& a, const std::string& comment) {
  const bool hasNormals = !a.cornerNormal.empty(), hasColors = !a.colors.empty(),
             hasUv = !a.cornerUv.empty();
  const std::vector<Vec3> normals = hasNormals ? vertexNormals(polygons, a) : std::vector<Vec3>();
  std::string out = "ply\nformat ascii 1.0\ncomment " + comment + "\n";
  out += formatText("element vertex %zu\n", polygons.positions.size());
  for (const char* name : {"x", "y", "z"}) out += formatText("property double %s\n", name);
  for (const char* name : {"nx", "ny", "nz"})
    if (hasNormals) out += formatText("property float %s\n", name);
  for (const char* name : {"red", "green", "blue", "alpha"})
    if (hasColors) out += formatText("property uchar %s\n", name);
  out += formatText("element face %d\nproperty list uchar int vertex_indices\n",
                    polygons.polygonCount());
  if (hasUv) out += "property list uchar float texcoord\n";
  out += "end_header\n";
  for (std::size_t v = 0; v < polygons.positions.size(); ++v) {
    const Vec3& p = polygons.positions[v];
    out += formatText("%.17g %.17g %.17g", p[0], p[1], p[2]);
    for (std::size_t k = 0; k < 3 && hasNormals; ++k) out += formatText(" %.9g", normals[v][k]);
    for (std::size_t k = 0; k < 4 && hasColors; ++k)
      out += formatText(" %d", byteOf(a.colors[v][k]));
    out += "\n";
  }
  for (std::size_t p = 0; p + 1 < polygons.start.size(); ++p) {
    const std::size_t first = polygons.start[p], end = polygons.start[p + 1];
    out += formatText("%zu", end - first);
    for (std::size_t c = first; c < end; ++c) out += formatText(" %d", polygons.cornerVertex[c]);
    if (hasUv) out += formatText(" %zu", 2 * (end - first));
    for (std::size_t c = first; c < end && hasUv; ++c) {
      const Vec2 uv = a.cornerUv[c] < 0 ? Vec2{0, 0} : a.uv[hgp::at(a.cornerUv[c])];
      out += formatText(" %.9g %.9g", uv[0], uv[1]);
    }
    out += "\n";
  }
  return asBytes(out);
}

Bytes polygonsAsGlb(const PolygonMesh& polygons, const Attributes& a,
                    const std::string& generator) {
  PlainFile file;
  PlainSurface& out = file.surfaces.emplace_back();
  out.mesh.positions = polygons.positions;
  out.uv = a.uv;
  out.normals = a.normals;
  out.materials = a.materials;
  out.colors = a.colors;
  for (std::array<double, 4>& color : out.colors)
    for (std::size_t k = 0; k < 3; ++k) color[k] = linearFromSrgb(color[k]);
  const auto addTo = [](std::vector<std::array<int, 3>>& list, const std::vector<int>& from,
                        const std::array<std::size_t, 3>& corners) {
    if (!from.empty()) list.push_back({from[corners[0]], from[corners[1]], from[corners[2]]});
  };
  for (std::size_t p = 0; p + 1 < polygons.start.size(); ++p)
    for (std::size_t c = polygons.start[p] + 1; c + 1 < polygons.start[p + 1]; ++c) {
      const std::array<std::size_t, 3> corners{polygons.start[p], c, c + 1};
      addTo(out.mesh.triangles, polygons.cornerVertex, corners);
      addTo(out.cornerUv, a.cornerUv, corners);
      addTo(out.cornerNormal, a.cornerNormal, corners);
      if (!a.polygonMaterial.empty()) out.triangleMaterial.push_back(a.polygonMaterial[p]);
    }
  return plainGlb(file, generator);
}

}  // namespace hgp::io
