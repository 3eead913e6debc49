#include "hgp/parametrize/mirror/mirrored_map.h"

#include <algorithm>
#include <utility>

#include "hgp/base/check.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

/// Ends of the half's boundary edges that lie in the plane, as uv indices.
struct PlaneEdge {
  int a = -1, b = -1;
  double length = 0.0;  ///< on the surface
};

std::vector<PlaneEdge> planeEdges(const Mirror& mirror, const HalfSurface& half, const UvMap& map) {
  std::vector<PlaneEdge> edges;
  for (HalfedgeId h : half.mesh.halfedges()) {
    if (!half.mesh.isBoundary(h)) continue;
    const VertexId a = half.mesh.tail(h), b = half.mesh.head(h);
    const VertexId from = half.vertexOrigin[at(a.i)], to = half.vertexOrigin[at(b.i)];
    if (mirror.image.vertex[from] != from || mirror.image.vertex[to] != to) continue;
    const auto& corners = map.cornerUv[at(TriMesh::face(h).i)];
    edges.push_back({corners[at(h.i % 3)], corners[at((h.i + 1) % 3)],
                     distance(half.mesh.position(a), half.mesh.position(b))});
  }
  return edges;
}

/// Moves the longest line of the plane to u = 0.
void moveToAxis(const std::vector<PlaneEdge>& edges, std::vector<Vec2>& uv) {
  struct Line {
    std::size_t axis;
    double place, length;
  };
  Line longest{0, 0.0, 0.0}, line = longest;
  for (const std::size_t k : {0, 1}) {
    std::vector<std::pair<double, double>>
        pieces;  // place, length: sums in no order of the triangles
    for (const PlaneEdge& e : edges)
      if (uv[at(e.a)][k] == uv[at(e.b)][k]) pieces.emplace_back(uv[at(e.a)][k], e.length);
    std::sort(pieces.begin(), pieces.end());
    for (const auto& [place, length] : pieces) {
      const bool isSame = k == line.axis && place == line.place;
      line = {k, place, length + (isSame ? line.length : 0.0)};
      if (line.length > longest.length) longest = line;
    }
  }
  HGP_CHECK(longest.length > 0.0, "the plane has straight edges");
  const auto [k, place, length] = longest;
  for (Vec2& p : uv) p = k == 0 ? Vec2{p[0] - place, p[1]} : Vec2{place - p[1], p[0]};
}

}  // namespace

CopiedMap mirroredMap(const TriMesh& mesh, const Mirror& mirror, const HalfSurface& half,
                      CopiedMap side) {
  const std::vector<PlaneEdge> edges = planeEdges(mirror, half, side.map);
  std::vector<Vec2>& uv = side.map.uv;
  moveToAxis(edges, uv);
  std::vector<int> image(uv.size(), -1);
  for (const PlaneEdge& e : edges)
    if (uv[at(e.a)][0] == 0.0 && uv[at(e.b)][0] == 0.0)
      for (const int end : {e.a, e.b}) image[at(end)] = end;
  CopiedMap out;
  out.map.uv = uv;
  for (const VertexId v : side.copyOf) out.copyOf.push_back(half.vertexOrigin[at(v.i)]);
  for (std::size_t c = 0; c < uv.size(); ++c) {
    if (image[c] >= 0) continue;
    image[c] = static_cast<int>(out.map.uv.size());
    out.map.uv.push_back({0.0 - uv[c][0], uv[c][1]});
    out.copyOf.push_back(mirror.image.vertex[out.copyOf[c]]);
  }
  out.map.cornerUv.assign(at(mesh.faceCount()), {-1, -1, -1});
  for (HalfedgeId h : half.mesh.halfedges()) {
    const int c = side.map.cornerUv[at(TriMesh::face(h).i)][at(h.i % 3)];
    const auto set = [&](HalfedgeId corner, int index) {
      out.map.cornerUv[at(TriMesh::face(corner).i)][at(corner.i % 3)] = index;
    };
    set(half.origin(h), c);
    set(TriMesh::next(mirror.image.halfedge[half.origin(h)]), image[at(c)]);
  }
  return out;
}

}  // namespace hgp
