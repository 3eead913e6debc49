#include "hgp/api/stored_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hgp::api {
namespace {

// Scales tried in turn when rounding to float32 breaks a map; powers of two would change nothing.
constexpr double kRetryScales[] = {1.0, 1.1875, 1.375, 1.625, 1.8125, 0.9375, 1.0625, 1.53125};
// Space between two components, relative to the width of the wider one.
constexpr double kGap = 0.05;

struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  void add(const Vec2& p) {
    for (std::size_t k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  double size(std::size_t k) const { return high[k] >= low[k] ? high[k] - low[k] : 0; }
};

Box boxOf(const std::vector<Vec2>& uv) {
  Box box;
  for (const Vec2& p : uv) box.add(p);
  return box;
}

/// A map on the corners of Model::mesh with the mesh vertex of every uv.
struct MeshMap {
  std::vector<Vec2> uv;
  std::vector<int> cornerUv;  ///< 3 per face of Model::mesh
  std::vector<int> copyOf;    ///< uv → mesh vertex
};

/// One row of components from left to right; a single component stays exactly where it is.
MeshMap joinComponents(const Model& model, const std::vector<ComponentMap>& components) {
  MeshMap out;
  out.cornerUv.assign(3 * model.mesh.triangles.size(), -1);
  double right = 0, width = 0;
  for (std::size_t p = 0; p < components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const Box box = boxOf(components[p].map.uv);
    width = std::max(width, box.size(0));
    Vec2 shift{0, 0};
    if (p > 0 && !components[p].map.uv.empty()) {
      shift = {right + kGap * width - box.low[0], -box.low[1]};
    }
    if (!components[p].map.uv.empty()) right = box.high[0] + shift[0];
    const int first = static_cast<int>(out.uv.size());
    for (std::size_t i = 0; i < components[p].map.uv.size(); ++i) {
      const Vec2& q = components[p].map.uv[i];
      out.uv.push_back({q[0] + shift[0], q[1] + shift[1]});
      const int v = components[p].copyOf[i].i;
      out.copyOf.push_back(v < 0 ? -1 : component.vertexOrigin[static_cast<std::size_t>(v)]);
    }
    for (std::size_t f = 0; f < components[p].map.cornerUv.size(); ++f) {
      const std::size_t at = 3 * static_cast<std::size_t>(component.faceOrigin[f]);
      for (std::size_t k = 0; k < 3; ++k)
        out.cornerUv[at + k] = first + components[p].map.cornerUv[f][k];
    }
  }
  return out;
}

double meanUvEdge(const MeshMap& map) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t c = 0; c < map.cornerUv.size(); ++c) {
    const std::size_t next = c % 3 == 2 ? c - 2 : c + 1;
    if (map.cornerUv[c] < 0 || map.cornerUv[next] < 0) continue;
    const Vec2& a = map.uv[static_cast<std::size_t>(map.cornerUv[c])];
    const Vec2& b = map.uv[static_cast<std::size_t>(map.cornerUv[next])];
    sum += std::hypot(b[0] - a[0], b[1] - a[1]);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

void moveAndScale(std::vector<Vec2>& uv, const Vec2& origin, double factor) {
  for (Vec2& p : uv) p = {(p[0] - origin[0]) * factor, (p[1] - origin[1]) * factor};
}

void applyScale(MeshMap& map, Scale scale) {
  if (scale == Scale::kUnit) {
    const double mean = meanUvEdge(map);
    if (mean > 0) moveAndScale(map.uv, {0, 0}, 1 / mean);
  } else if (scale == Scale::kFit) {
    const Box box = boxOf(map.uv);
    const double size = std::max(box.size(0), box.size(1));
    // Rounding must not push the far side beyond 1.
    if (size > 0) moveAndScale(map.uv, box.low, (1 - 1e-7) / size);
  }
}

/// Corners of faces that the solve did not see take any uv of their vertex.
UvMap onSurface(const Model& model, const MeshMap& from) {
  UvMap out;
  out.uv = from.uv;
  const auto& triangles = model.source().mesh.triangles;
  out.cornerUv.assign(triangles.size(), {-1, -1, -1});
  for (std::size_t c = 0; c < from.cornerUv.size(); ++c) {
    const int origin = model.cornerOrigin[c];
    if (origin < 0) continue;
    out.cornerUv[static_cast<std::size_t>(origin / 3)][static_cast<std::size_t>(origin % 3)] =
        from.cornerUv[c];
  }
  std::vector<int> anyCopy;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      int& slot = out.cornerUv[t][k];
      if (slot >= 0) continue;
      if (anyCopy.empty()) {
        anyCopy.assign(model.mesh.positions.size(), -1);
        for (std::size_t i = 0; i < from.copyOf.size(); ++i) {
          if (from.copyOf[i] >= 0)
            anyCopy[static_cast<std::size_t>(from.copyOf[i])] = static_cast<int>(i);
        }
      }
      const int v = triangles[t][k];
      const int image = v < 0 || v >= static_cast<int>(model.vertexImage.size())
                            ? -1
                            : model.vertexImage[static_cast<std::size_t>(v)];
      slot = image < 0 ? -1 : anyCopy[static_cast<std::size_t>(image)];
      if (slot < 0) {
        slot = static_cast<int>(out.uv.size());
        out.uv.push_back({0, 0});
      }
    }
  }
  return out;
}

std::vector<std::uint32_t> verticesOfUv(const Model& model, const UvMap& map) {
  std::vector<std::uint32_t> out(map.uv.size(), 0);
  const auto& triangles = model.source().mesh.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      out[static_cast<std::size_t>(map.cornerUv[t][k])] =
          static_cast<std::uint32_t>(triangles[t][k]);
    }
  }
  return out;
}

/// The same numbers at every corner.
bool isSame(const UvMap& a, const UvMap& b) {
  if (a.cornerUv.size() != b.cornerUv.size()) return false;
  for (std::size_t f = 0; f < a.cornerUv.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = a.cornerUv[f][k], j = b.cornerUv[f][k];
      if (i < 0 || j < 0) return false;
      if (a.uv[static_cast<std::size_t>(i)] != b.uv[static_cast<std::size_t>(j)]) return false;
    }
  return true;
}

/// A component whose numbers the format leaves as they are has been judged already.
StoredMap judge(const Model& model, const std::vector<ComponentMap>& components,
                const UvMap& surfaceMap) {
  StoredMap out;
  out.map = model.document->asStored(model.surface, surfaceMap);
  CertifyOptions options;
  const bool isFloat = model.document->uvPrecision() == io::UvPrecision::kFloat32;
  options.precision = isFloat ? Precision::kFloat32 : Precision::kFloat64;
  options.gridStep = isFloat ? gridStep(out.map) : 0.0;
  for (std::size_t p = 0; p < components.size(); ++p) {
    const UvMap stored = mapOfComponent(model, model.components[p], out.map);
    out.certificates.push_back(
        !isFloat && isSame(stored, components[p].map)
            ? components[p].certificate
            : certify(model.components[p].mesh, components[p].spec, stored, options));
  }
  out.isCertified = areCertified(out.certificates);
  return out;
}

}  // namespace

double gridStep(const UvMap& map) {
  // What stores v as 1 − v rounds that.
  double largest = 0;
  for (const auto& corners : map.cornerUv)
    for (int i : corners) {
      if (i < 0 || i >= static_cast<int>(map.uv.size())) continue;
      const Vec2& p = map.uv[static_cast<std::size_t>(i)];
      largest = std::max({largest, std::abs(p[0]), std::abs(p[1]), std::abs(1 - p[1])});
    }
  return largest > 0 && std::isfinite(largest) ? std::scalbn(1.0, std::ilogb(largest) - 23) : 0;
}

StoredMap storeMap(const Model& model, const std::vector<ComponentMap>& components, Scale scale,
                   bool wasCertified) {
  MeshMap joined = joinComponents(model, components);
  applyScale(joined, scale);
  StoredMap first = judge(model, components, onSurface(model, joined));
  const bool mayMove = wasCertified && scale == Scale::kSolved;
  if (!first.isCertified && mayMove) {
    const Box box = boxOf(joined.uv);
    const Vec2 centre{(box.low[0] + box.high[0]) / 2, (box.low[1] + box.high[1]) / 2};
    for (double factor : kRetryScales) {
      MeshMap moved = joined;
      moveAndScale(moved.uv, centre, factor);
      StoredMap again = judge(model, components, onSurface(model, moved));
      if (!again.isCertified) continue;
      again.notes.push_back(
          "the map was moved and scaled so that it survives the rounding of the "
          "format");
      first = std::move(again);
      break;
    }
    if (!first.isCertified) {
      first.notes.push_back(
          "the map was certified before the rounding of the format, and is not "
          "after it");
    }
  }
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    first.certificates[p].overlap =
        measureOverlap(mapOfComponent(model, model.components[p], first.map));
  }
  first.uvToVertex = verticesOfUv(model, first.map);
  return first;
}

UvMap mapOfComponent(const Model& model, const ModelComponent& component, const UvMap& surfaceMap) {
  UvMap out;
  out.uv = surfaceMap.uv;
  out.cornerUv.resize(component.faceOrigin.size());
  std::vector<int> anyCopy;
  for (std::size_t f = 0; f < component.faceOrigin.size(); ++f) {
    const std::size_t inMesh = static_cast<std::size_t>(component.faceOrigin[f]);
    for (std::size_t k = 0; k < 3; ++k) {
      const int origin = model.cornerOrigin[3 * inMesh + k];
      if (origin >= 0) {
        out.cornerUv[f][k] = surfaceMap.cornerUv[static_cast<std::size_t>(origin / 3)]
                                                [static_cast<std::size_t>(origin % 3)];
        continue;
      }
      if (anyCopy.empty()) {
        anyCopy.assign(model.source().mesh.positions.size(), -1);
        for (std::size_t t = 0; t < surfaceMap.cornerUv.size(); ++t) {
          for (std::size_t j = 0; j < 3; ++j) {
            const int v = model.source().mesh.triangles[t][j];
            anyCopy[static_cast<std::size_t>(v)] = surfaceMap.cornerUv[t][j];
          }
        }
      }
      const int v = model.vertexOrigin[static_cast<std::size_t>(model.mesh.triangles[inMesh][k])];
      out.cornerUv[f][k] = v < 0 ? -1 : anyCopy[static_cast<std::size_t>(v)];
    }
  }
  return out;
}

SeamEnds seamEnds(const Model& model, const ModelComponent& component, const UvMap& surfaceMap,
                  EdgeId edge) {
  const auto uvAt = [&](HalfedgeId corner) {
    const int inMesh = component.faceOrigin[static_cast<std::size_t>(corner.i / 3)];
    const int origin = model.cornerOrigin[static_cast<std::size_t>(3 * inMesh + corner.i % 3)];
    return origin < 0 ? -1
                      : surfaceMap.cornerUv[static_cast<std::size_t>(origin / 3)]
                                           [static_cast<std::size_t>(origin % 3)];
  };
  const HalfedgeId h = component.mesh.halfedge(edge);
  const HalfedgeId twin = component.mesh.twin(h);
  SeamEnds out;
  out.a[0] = uvAt(h);
  out.a[1] = uvAt(TriMesh::next(h));
  out.b[0] = uvAt(TriMesh::next(twin));
  out.b[1] = uvAt(twin);
  return out;
}

}  // namespace hgp::api
