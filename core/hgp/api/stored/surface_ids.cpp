#include <algorithm>
#include <cmath>
#include <string>

#include "hgp/api/model/model.h"
#include "hgp/api/stored/stored_map.h"
#include "hgp/base/check.h"

namespace hgp::api {

void toSurfaceIds(const ModelComponent& component, std::vector<Where>& where) {
  const auto vertex = [&](std::int64_t& v) {
    const VertexId id{static_cast<int>(v)};
    if (component.vertex.has(id)) v = component.vertex[id].i;
  };
  for (Where& w : where) {
    if (w.kind == Where::Kind::kVertex || w.kind == Where::Kind::kEdge) {
      vertex(w.id);
      vertex(w.other);
    } else if (const FaceId f{static_cast<int>(w.id)};
               w.kind == Where::Kind::kFace && component.face.has(f)) {
      w.id = component.face[f].i;
    } else if (const LoopId loop{static_cast<int>(w.id)};
               w.kind == Where::Kind::kLoop && component.loop.has(loop)) {
      w.id = component.loop[loop].i;
    }
  }
}

namespace {

int surfaceId(const ModelComponent& component, const NamedId& named) {
  switch (named.kind) {
    case NamedId::Kind::kVertex:
      return component.vertex[VertexId{named.id}].i;
    case NamedId::Kind::kLoop:
      return component.loop[LoopId{named.id}].i;
    case NamedId::Kind::kHandle:
      return component.generatorOffset + named.id;
  }
  return named.id;
}

}  // namespace

Reason toSurfaceIds(const ModelComponent& component, Reason reason) {
  toSurfaceIds(component, reason.where);
  if (!reason.named) return reason;
  NamedId& named = *reason.named;
  const std::size_t digits = std::to_string(named.id).size();
  named.id = surfaceId(component, named);
  reason.message.replace(named.at, digits, std::to_string(named.id));
  return reason;
}

Failure toSurfaceIds(const Model& model, const ModelComponent& component, Failure failure) {
  toSurfaceIds(component, failure.where);
  if (model.components.size() > 1) {
    failure.message =
        formatText("component %d: ", static_cast<int>(&component - model.components.data())) +
        failure.message;
  }
  return failure;
}

SeamEnds seamEnds(const ModelComponent& component, const UvMap& surfaceMap, EdgeId edge) {
  const auto uvAt = [&](HalfedgeId corner) {
    const SurfaceCornerId at = component.corner[corner];
    return at.isValid() ? surfaceMap.cornerUv[hgp::at(at.i / 3)][hgp::at(at.i % 3)] : -1;
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
