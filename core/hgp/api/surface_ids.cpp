#include <algorithm>
#include <cmath>

#include "hgp/api/model.h"
#include "hgp/api/stored_map.h"
#include "hgp/base/check.h"

namespace hgp::api {

void toSurfaceIds(const Model& model, const ModelComponent& component, std::vector<Where>& where) {
  const auto vertex = [&](std::int64_t& v) {
    if (v < 0 || v >= static_cast<std::int64_t>(component.vertexOrigin.size())) return;
    const int inMesh = component.vertexOrigin[static_cast<std::size_t>(v)];
    v = model.vertexOrigin[static_cast<std::size_t>(inMesh)];
  };
  for (Where& w : where) {
    if (w.kind == Where::Kind::kVertex || w.kind == Where::Kind::kEdge) {
      vertex(w.id);
      vertex(w.other);
    } else if (w.kind == Where::Kind::kFace &&
               w.id < static_cast<std::int64_t>(component.faceOrigin.size()) && w.id >= 0) {
      w.id = model.faceOrigin[static_cast<std::size_t>(
          component.faceOrigin[static_cast<std::size_t>(w.id)])];
    } else if (w.kind == Where::Kind::kLoop &&
               w.id < static_cast<std::int64_t>(component.loopOrigin.size()) && w.id >= 0) {
      w.id = component.loopOrigin[static_cast<std::size_t>(w.id)];
    }
  }
}

Failure toSurfaceIds(const Model& model, const ModelComponent& component, Failure failure) {
  toSurfaceIds(model, component, failure.where);
  if (model.components.size() > 1) {
    failure.message =
        formatText("component %d: ", static_cast<int>(&component - model.components.data())) +
        failure.message;
  }
  return failure;
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
