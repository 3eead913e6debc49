#include "hgp/api/stored/outside.h"

#include <unordered_map>

namespace hgp::api {
namespace {

using Triple = std::array<int, 3>;

const Triple& triangleOf(const Model& model, int face) {
  return model.source().mesh.triangles[static_cast<std::size_t>(face)];
}

/// The vertex of Model::mesh for a vertex of the surface: always the same one of its copies if it was split.
int imageOf(const Model& model, int vertex) { return model.vertexImage[SurfaceVertexId{vertex}].i; }

/// The corner of triangle `other` that has this vertex, or −1.
int cornerOf(const Model& model, const Triple& other, int vertex) {
  for (int k = 0; k < 3; ++k)
    if (imageOf(model, other[static_cast<std::size_t>(k)]) == imageOf(model, vertex)) return k;
  return -1;
}

int uvAt(const UvMap& map, int face, int corner) {
  return map.cornerUv[static_cast<std::size_t>(face)][static_cast<std::size_t>(corner)];
}

/// The verified triangles around the vertices of triangles without area.
class Neighbours {
 public:
  Neighbours(const Model& model, const UvMap& map) : model_(model) {
    for (const LeftOutFace& left : model.leftOut)
      if (left.why == LeftOut::kZeroArea)
        for (int v : triangleOf(model, left.face)) faces_[imageOf(model, v)];
    for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
      if (map.cornerUv[t][0] < 0) continue;
      for (int v : model.source().mesh.triangles[t]) {
        const auto found = faces_.find(imageOf(model, v));
        if (found != faces_.end()) found->second.push_back(static_cast<int>(t));
      }
    }
  }

  /// The triangle around `vertex` that shares the most vertices with this one, or −1.
  int best(const Triple& triangle, int vertex) const {
    int best = -1, most = 0;
    for (int f : faces_.at(imageOf(model_, vertex))) {
      int shared = 0;
      for (int v : triangle) shared += cornerOf(model_, triangleOf(model_, f), v) >= 0;
      if (shared > most) {
        most = shared;
        best = f;
      }
    }
    return best;
  }

 private:
  const Model& model_;
  std::unordered_map<int, std::vector<int>> faces_;
};

}  // namespace

void fillOutside(const Model& model, UvMap& map) {
  if (model.leftOut.empty()) return;
  const Neighbours neighbours(model, map);
  const Vec2 somewhere = map.uv.empty() ? Vec2{0, 0} : map.uv[0];
  std::unordered_map<int, int> alone;  // vertex without a verified triangle → its uv
  for (const LeftOutFace& left : model.leftOut) {
    const Triple& triangle = triangleOf(model, left.face);
    for (std::size_t k = 0; k < 3; ++k) {
      const int source =
          left.why == LeftOut::kDuplicate ? left.twin : neighbours.best(triangle, triangle[k]);
      int& slot = map.cornerUv[static_cast<std::size_t>(left.face)][k];
      if (source >= 0) {
        slot = uvAt(map, source, cornerOf(model, triangleOf(model, source), triangle[k]));
        continue;
      }
      const auto [it, isNew] = alone.try_emplace(triangle[k], static_cast<int>(map.uv.size()));
      if (isNew) map.uv.push_back(somewhere);
      slot = it->second;
    }
  }
}

OutsideFacts measureOutside(const Model& model, const UvMap& surfaceMap) {
  OutsideFacts facts;
  facts.stored = static_cast<int>(model.source().mesh.triangles.size());
  facts.verified = static_cast<int>(model.mesh.triangles.size());
  facts.splitVertices = model.splitVertices;
  const std::vector<int>& corner = model.cornerOrigin.raw();
  for (std::size_t f = 0; f < model.mesh.triangles.size(); ++f)
    facts.reversed += (corner[3 * f + 1] - corner[3 * f] + 3) % 3 == 2;
  for (const LeftOutFace& left : model.leftOut) {
    if (left.why == LeftOut::kZeroArea) {
      ++facts.zeroArea;
      continue;
    }
    ++facts.duplicates;
    const Triple& triangle = triangleOf(model, left.face);
    bool isSame = true;
    for (int k = 0; k < 3 && isSame; ++k) {
      const int there =
          cornerOf(model, triangleOf(model, left.twin), triangle[static_cast<std::size_t>(k)]);
      const int a = uvAt(surfaceMap, left.face, k);
      const int b = there < 0 ? -1 : uvAt(surfaceMap, left.twin, there);
      isSame =
          a >= 0 && b >= 0 &&
          surfaceMap.uv[static_cast<std::size_t>(a)] == surfaceMap.uv[static_cast<std::size_t>(b)];
    }
    facts.differing += !isSame;
  }
  facts.polygons = measurePolygons(model, model.document->polygons(model.surface), surfaceMap);
  return facts;
}

}  // namespace hgp::api
