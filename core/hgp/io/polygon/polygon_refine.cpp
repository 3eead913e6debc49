#include "hgp/io/polygon/polygon_refine.h"

namespace hgp::io {

int MeanValues::of(int a, int b) {
  if (a == b || a < 0 || b < 0) return a == b ? a : -1;
  const VertexPair pair = a < b ? VertexPair{a, b} : VertexPair{b, a};
  const auto [it, isNew] = found_.try_emplace(pair, count_ + static_cast<int>(pairs_.size()));
  if (isNew) pairs_.push_back(pair);
  return it->second;
}

RefinedPolygons splitEdges(const PolygonMesh& polygons, const TriangleCorners& corners,
                           const MeshData& triangles, const std::vector<VertexPair>& edges) {
  RefinedMesh refined = splitEdges(triangles, edges);
  RefinedPolygons out;
  out.polygons.positions = std::move(refined.mesh.positions);
  out.parents = std::move(refined.parents);
  const auto end = [&](std::vector<char>::value_type isSame, int p) {
    out.polygons.start.push_back(static_cast<std::uint32_t>(out.polygons.cornerVertex.size()));
    out.polygonOrigin.push_back(p);
    out.isSame.push_back(isSame);
  };
  std::size_t child = 0;
  for (int p = 0; p < polygons.polygonCount(); ++p) {
    const std::size_t first = child;
    while (child < refined.faceOrigin.size() &&
           refined.faceOrigin[child] < polygons.firstTriangle(p + 1))
      ++child;
    const int before = polygons.firstTriangle(p + 1) - polygons.firstTriangle(p);
    if (static_cast<int>(child - first) == before) {
      for (auto c = polygons.start[static_cast<std::size_t>(p)];
           c < polygons.start[static_cast<std::size_t>(p) + 1]; ++c) {
        out.polygons.cornerVertex.push_back(polygons.cornerVertex[c]);
        out.corners.push_back({static_cast<int>(c), static_cast<int>(c)});
      }
      end(1, p);
      continue;
    }
    for (std::size_t f = first; f < child; ++f) {
      const int t = refined.faceOrigin[f];
      for (std::size_t k = 0; k < 3; ++k) {
        out.polygons.cornerVertex.push_back(refined.mesh.triangles[f][k]);
        VertexPair pair{};
        for (std::size_t i = 0; i < 2; ++i) {
          const int corner = refined.cornerOrigin[f][k][i];
          pair[i] = corners.empty()
                        ? 3 * t + corner
                        : corners[static_cast<std::size_t>(t)][static_cast<std::size_t>(corner)];
        }
        out.corners.push_back(pair);
      }
      end(0, p);
    }
  }
  return out;
}

}  // namespace hgp::io
