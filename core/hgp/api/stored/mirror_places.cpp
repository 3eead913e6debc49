#include "hgp/api/stored/mirror_places.h"

#include <cmath>

#include "hgp/base/check.h"

namespace hgp::api {

MirrorPlaces::MirrorPlaces(const TriMesh& mesh, const Mirror& mirror, const UvMap& map)
    : mesh_(&mesh), half_(halfOf(mesh, mirror.image, mirror.plane)) {
  const Reflection& own = mirror.image;
  const auto uvAt = [&](HalfedgeId h) { return map.cornerUv[at(TriMesh::face(h).i)][at(h.i % 3)]; };
  std::vector<int> number(map.uv.size(), -1);
  cornerUv_.resize(at(half_.mesh.faceCount()));
  for (HalfedgeId h : half_.mesh.halfedges()) {
    const HalfedgeId whole = half_.origin(h);
    const int from = uvAt(whole), to = uvAt(TriMesh::next(own.halfedge[whole]));
    int& n = number[at(from)];
    if (n < 0) {
      n = static_cast<int>(index_.size());
      index_.push_back(from);
      image_.push_back(to);
      if (from == to) axis_ = n;
    }
    cornerUv_[at(TriMesh::face(h).i)][at(h.i % 3)] = n;
  }
  HGP_CHECK(axis_ >= 0, "both sides of a symmetric map share a line");
}

std::vector<Vec2> MirrorPlaces::sideOf(const std::vector<Vec2>& uv) const {
  std::vector<Vec2> side;
  side.reserve(index_.size());
  for (const int i : index_) side.push_back(uv[at(i)]);
  return side;
}

std::optional<SeamSnapper> MirrorPlaces::snapper(const CompleteSpec& spec,
                                                 const std::vector<Vec2>& uv) const {
  PerVertex<char> isCone(at(mesh_->vertexCount()), 0);
  PerEdge<char> isFeature(at(mesh_->edgeCount()), 0);
  for (const ConePoint& cone : spec.cones) isCone[cone.vertex] = 1;
  for (EdgeId e : spec.features) isFeature[e] = 1;
  std::vector<VertexId> cones;
  std::vector<EdgeId> features;
  for (VertexId v : half_.mesh.vertices())
    if (isCone[half_.vertexOrigin[at(v.i)]] && !half_.mesh.isBoundary(v)) cones.push_back(v);
  for (EdgeId e : half_.mesh.edges())
    if (isFeature[mesh_->edge(half_.origin(half_.mesh.halfedge(e)))]) features.push_back(e);
  return SeamSnapper::make(half_.mesh, {sideOf(uv), cornerUv_}, spec.q, cones, features);
}

void MirrorPlaces::keepPlane(const std::vector<Vec2>& before, int exponent,
                             std::vector<Vec2>& side) const {
  const double step = std::ldexp(1.0, exponent);
  const double move = std::nearbyint(before[at(axis_)][0] / step) * step - side[at(axis_)][0];
  for (Vec2& p : side) p[0] += move;
}

void MirrorPlaces::spread(const std::vector<Vec2>& side, std::vector<Vec2>& uv) const {
  const double twice = 2.0 * side[at(axis_)][0];
  for (std::size_t n = 0; n < side.size(); ++n) {
    uv[at(index_[n])] = side[n];
    if (image_[n] != index_[n]) uv[at(image_[n])] = {twice - side[n][0], side[n][1]};
  }
}

}  // namespace hgp::api
