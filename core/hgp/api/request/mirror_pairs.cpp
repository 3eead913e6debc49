#include "hgp/api/request/mirror_pairs.h"

#include <algorithm>

#include "hgp/parametrize/mirror/symmetric.h"

namespace hgp::api {
namespace {

using Cones = std::vector<ConePoint>;

/// The vertices of `a` of which `b` lacks the cone.
void addMissing(const Cones& a, const Cones& b, int q, std::vector<Where>& where) {
  for (const ConePoint& cone : a)
    if (cone.k != q && std::none_of(b.begin(), b.end(), [&](const ConePoint& other) {
          return other.vertex == cone.vertex && other.k == cone.k;
        }))
      where.push_back({Where::Kind::kVertex, cone.vertex.i});
}

Cones imagesOf(const Cones& cones, const Mirror& mirror) {
  Cones images;
  for (const ConePoint& cone : cones) images.push_back({mirror.image.vertex[cone.vertex], cone.k});
  return images;
}

}  // namespace

Status joinPair(const Model& model, std::size_t second, Request& request) {
  ComponentRequest& to = request.components[second];
  const Mirror& mirror = *to.mirror;
  ComponentRequest& from = request.components[at(mirror.of)];
  const TriMesh& fromMesh = model.components[at(mirror.of)].mesh;
  const TriMesh& toMesh = model.components[second].mesh;
  if (from.spec.cones.empty() && !to.spec.cones.empty()) {
    PerVertex<VertexId> source(at(toMesh.vertexCount()));
    for (VertexId v : fromMesh.vertices()) source[mirror.image.vertex[v]] = v;
    for (const ConePoint& cone : to.spec.cones)
      from.spec.cones.push_back({source[cone.vertex], cone.k});
    from.isAutomatic = false;
  } else if (!to.isAutomatic && !to.spec.cones.empty()) {
    const Cones images = imagesOf(from.spec.cones, mirror);
    std::vector<Where> where;
    addMissing(images, to.spec.cones, request.q, where);
    addMissing(to.spec.cones, images, request.q, where);
    if (!where.empty())
      return toSurfaceIds(model, model.components[second], unpairedCones(std::move(where)));
  }
  PerEdge<char> isFeature(at(toMesh.edgeCount()), 0);
  for (EdgeId e : to.spec.features) isFeature[e] = 1;
  for (EdgeId e : from.spec.features)
    isFeature[toMesh.edge(mirror.image.halfedge[fromMesh.halfedge(e)])] = 1;
  from.spec.features.clear();
  to.spec.features.clear();
  for (EdgeId e : fromMesh.edges())
    if (isFeature[toMesh.edge(mirror.image.halfedge[fromMesh.halfedge(e)])])
      from.spec.features.push_back(e);
  for (EdgeId e : toMesh.edges())
    if (isFeature[e]) to.spec.features.push_back(e);
  return Done{};
}

}  // namespace hgp::api
