#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/plain_surface.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {
namespace {

constexpr int kVertexTarget = 34962, kIndexTarget = 34963;

/// A JSON string literal; names are assumed to be UTF-8.
std::string plainQuoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20)
      out += formatText("\\u%04x", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

/// The normals of the triangles at each vertex together, weighted by area; not of length 1.
std::vector<Vec3> shapeNormals(const MeshData& mesh) {
  std::vector<Vec3> out(mesh.positions.size(), Vec3{});
  const auto at = [&](int v) -> const Vec3& { return mesh.positions[static_cast<std::size_t>(v)]; };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 n = cross(subtract(at(j), at(i)), subtract(at(k), at(i)));
    for (const int v : {i, j, k})
      out[static_cast<std::size_t>(v)] = add(out[static_cast<std::size_t>(v)], n);
  }
  return out;
}

/// Builds the elements of a JSON array.
struct PlainJsonList {
  std::string text;
  int count = 0;
  int add(const std::string& element) {
    text += (count > 0 ? "," : "") + element;
    return count++;
  }
};

class PlainGlbText {
 public:
  void add(const PlainSurface& surface) {
    splitVertices(surface);
    std::string attributes = formatText("\"POSITION\":%d", addPositions(surface));
    if (!surface.cornerNormal.empty())
      attributes += formatText(",\"NORMAL\":%d", addNormals(surface));
    if (!surface.cornerUv.empty()) attributes += formatText(",\"TEXCOORD_0\":%d", addUv(surface));
    if (!surface.colors.empty()) attributes += formatText(",\"COLOR_0\":%d", addColors(surface));
    PlainJsonList primitives;
    for (const auto& [material, triangles] : groups(surface)) {
      std::string one = formatText("{\"attributes\":{%s},\"indices\":%d", attributes.c_str(),
                                   addIndices(triangles));
      if (material >= 0)
        one += formatText(",\"material\":%d",
                          materialOf(surface.materials[static_cast<std::size_t>(material)]));
      primitives.add(one + "}");
    }
    const std::string name =
        surface.name.empty() ? "" : "\"name\":" + plainQuoted(surface.name) + ",";
    const int mesh = meshes_.add("{" + name + "\"primitives\":[" + primitives.text + "]}");
    nodes_.add("{" + name + formatText("\"mesh\":%d}", mesh));
  }

  Bytes file(const std::string& generator) {
    std::string roots;
    for (int i = 0; i < nodes_.count; ++i) roots += formatText(i > 0 ? ",%d" : "%d", i);
    std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":" + plainQuoted(generator) +
                       "},\"scene\":0,\"scenes\":[{\"nodes\":[" + roots + "]}],\"nodes\":[" +
                       nodes_.text + "],\"meshes\":[" + meshes_.text + "],";
    if (materials_.count > 0) json += "\"materials\":[" + materials_.text + "],";
    json += "\"accessors\":[" + accessors_.text + "],\"bufferViews\":[" + views_.text +
            formatText("],\"buffers\":[{\"byteLength\":%zu}]}", data_.size());
    while (json.size() % 4 != 0) json += ' ';
    Bytes out;
    out.reserve(28 + json.size() + data_.size());
    for (const std::size_t x :
         {std::size_t{0x46546C67}, std::size_t{2}, 28 + json.size() + data_.size(), json.size(),
          std::size_t{0x4E4F534A}})
      word(out, static_cast<std::uint32_t>(x));
    out.insert(out.end(), json.begin(), json.end());
    word(out, static_cast<std::uint32_t>(data_.size()));
    word(out, 0x004E4942);
    out.insert(out.end(), data_.begin(), data_.end());
    return out;
  }

 private:
  static void word(Bytes& out, std::uint32_t x) {
    for (int k = 0; k < 4; ++k) out.push_back(static_cast<std::uint8_t>(x >> (8 * k)));
  }
  void number(double x) {
    const auto rounded = static_cast<float>(x);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &rounded, sizeof bits);
    word(data_, bits);
  }

  /// Makes one copy of a vertex per normal and uv. Vertices keep their order, the copies of a vertex are consecutive, and
  /// vertices without triangles are kept.
  void splitVertices(const PlainSurface& surface) {
    const std::size_t count = surface.mesh.positions.size();
    using NormalAndUv = std::array<int, 2>;
    std::vector<std::vector<NormalAndUv>> valuesOf(count);
    const auto valuesAt = [&](std::size_t t, std::size_t k) {
      return NormalAndUv{surface.cornerNormal.empty() ? -1 : surface.cornerNormal[t][k],
                         surface.cornerUv.empty() ? -1 : surface.cornerUv[t][k]};
    };
    const auto& triangles = surface.mesh.triangles;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        auto& list = valuesOf[static_cast<std::size_t>(triangles[t][k])];
        const NormalAndUv here = valuesAt(t, k);
        if (std::find(list.begin(), list.end(), here) == list.end()) list.push_back(here);
      }
    }
    vertexOf_.clear();
    normalOf_.clear();
    uvOf_.clear();
    std::vector<int> first(count);
    for (std::size_t v = 0; v < count; ++v) {
      first[v] = static_cast<int>(vertexOf_.size());
      if (valuesOf[v].empty()) valuesOf[v].push_back({-1, -1});
      for (const auto& [normal, uv] : valuesOf[v]) {
        vertexOf_.push_back(static_cast<int>(v));
        normalOf_.push_back(normal);
        uvOf_.push_back(uv);
      }
    }
    corners_.assign(triangles.size(), {});
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto v = static_cast<std::size_t>(triangles[t][k]);
        const auto& list = valuesOf[v];
        const auto at = std::find(list.begin(), list.end(), valuesAt(t, k)) - list.begin();
        corners_[t][k] = first[v] + static_cast<int>(at);
      }
    }
  }

  int addAccessor(std::size_t begin, std::size_t count, int target, const std::string& kind) {
    const int view =
        views_.add(formatText("{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}",
                              begin, data_.size() - begin, target));
    const int accessor = accessors_.add(
        formatText("{\"bufferView\":%d,\"count\":%zu,%s}", view, count, kind.c_str()));
    while (data_.size() % 4 != 0) data_.push_back(0);
    return accessor;
  }

  int addPositions(const PlainSurface& surface) {
    const std::size_t begin = data_.size();
    std::array<float, 3> low{}, high{};
    bool isFirst = true;
    for (const int v : vertexOf_) {
      const Vec3& p = surface.mesh.positions[static_cast<std::size_t>(v)];
      for (std::size_t k = 0; k < 3; ++k) number(p[k]);
      if (!isFinite(p)) continue;  // this defect is reported when the result is read
      for (std::size_t k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(p[k]);
        low[k] = isFirst ? x : std::min(low[k], x);
        high[k] = isFirst ? x : std::max(high[k], x);
      }
      isFirst = false;
    }
    const auto list = [](const std::array<float, 3>& x) {
      return formatText("[%.9g,%.9g,%.9g]", static_cast<double>(x[0]), static_cast<double>(x[1]),
                        static_cast<double>(x[2]));
    };
    return addAccessor(
        begin, vertexOf_.size(), kVertexTarget,
        "\"componentType\":5126,\"type\":\"VEC3\",\"min\":" + list(low) + ",\"max\":" + list(high));
  }

  int addNormals(const PlainSurface& surface) {
    const std::size_t begin = data_.size();
    std::vector<Vec3> ofShape;
    for (std::size_t i = 0; i < normalOf_.size(); ++i) {
      const int n = normalOf_[i];
      Vec3 x = n >= 0 ? surface.normals[static_cast<std::size_t>(n)] : Vec3{};
      if (!(norm(x) > 0)) {
        if (ofShape.empty()) ofShape = shapeNormals(surface.mesh);
        x = ofShape[static_cast<std::size_t>(vertexOf_[i])];
      }
      const double length = norm(x);
      if (!(length > 0)) x = {0, 0, 1};
      for (const double c : x) number(length > 0 ? c / length : c);
    }
    return addAccessor(begin, normalOf_.size(), kVertexTarget,
                       "\"componentType\":5126,\"type\":\"VEC3\"");
  }

  int addUv(const PlainSurface& surface) {
    const std::size_t begin = data_.size();
    for (const int i : uvOf_) {
      const Vec2 uv = i >= 0 ? surface.uv[static_cast<std::size_t>(i)] : Vec2{0, 1};
      number(uv[0]);
      number(1 - uv[1]);
    }
    return addAccessor(begin, uvOf_.size(), kVertexTarget,
                       "\"componentType\":5126,\"type\":\"VEC2\"");
  }

  int addColors(const PlainSurface& surface) {
    const std::size_t begin = data_.size();
    for (const int v : vertexOf_) {
      for (const double c : surface.colors[static_cast<std::size_t>(v)]) {
        const double share = c > 0 ? std::min(c, 1.0) : 0;  // NaN becomes 0
        const auto bits = static_cast<unsigned>(std::lround(65535 * share));
        data_.push_back(static_cast<std::uint8_t>(bits & 0xFF));
        data_.push_back(static_cast<std::uint8_t>(bits >> 8));
      }
    }
    return addAccessor(begin, vertexOf_.size(), kVertexTarget,
                       "\"componentType\":5123,\"normalized\":true,\"type\":\"VEC4\"");
  }

  /// Triangles by material, in the order in which the materials appear.
  static std::vector<std::pair<int, std::vector<std::size_t>>> groups(const PlainSurface& surface) {
    std::vector<std::pair<int, std::vector<std::size_t>>> out;
    std::map<int, std::size_t> index;
    for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
      const int material = surface.triangleMaterial.empty() ? -1 : surface.triangleMaterial[t];
      const auto [found, isNew] = index.try_emplace(material, out.size());
      if (isNew) out.push_back({material, {}});
      out[found->second].second.push_back(t);
    }
    return out;
  }

  int addIndices(const std::vector<std::size_t>& triangles) {
    const std::size_t begin = data_.size();
    for (const std::size_t t : triangles)
      for (const int v : corners_[t]) word(data_, static_cast<std::uint32_t>(v));
    return addAccessor(begin, 3 * triangles.size(), kIndexTarget,
                       "\"componentType\":5125,\"type\":\"SCALAR\"");
  }

  int materialOf(const std::string& name) {
    const auto [found, isNew] = materialIds_.try_emplace(name, materials_.count);
    if (isNew) materials_.add("{\"name\":" + plainQuoted(name) + "}");
    return found->second;
  }

  Bytes data_;
  PlainJsonList nodes_, meshes_, materials_, accessors_, views_;
  std::map<std::string, int> materialIds_;
  std::vector<int> vertexOf_, normalOf_, uvOf_;  ///< of stored vertices
  std::vector<std::array<int, 3>> corners_;      ///< stored vertices of triangles
};

}  // namespace

Bytes plainGlb(const PlainFile& file, const std::string& generator) {
  PlainGlbText out;
  for (const PlainSurface& surface : file.surfaces) out.add(surface);
  return out.file(generator);
}

}  // namespace hgp::io
