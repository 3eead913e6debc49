#include "hgp/api/stored/stand_in.h"

#include "hgp/api/stored/stored_map.h"
#include "hgp/mesh/box.h"
#include "hgp/parametrize/parametrize.h"

namespace hgp::api {
namespace {

/// A projection along the coordinate axis in which the component's bounding box is thinnest.
UvMap flatMap(const TriMesh& mesh) {
  Box<3> box;
  for (VertexId v : mesh.vertices()) box.add(mesh.position(v));
  std::size_t thin = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (box.size(k) < box.size(thin)) thin = k;
  }
  UvMap map;
  for (int v = 0; v < mesh.vertexCount(); ++v) {
    const Vec3 p = mesh.position(VertexId{v});
    map.uv.push_back({p[(thin + 1) % 3], p[(thin + 2) % 3]});
  }
  for (int f = 0; f < mesh.faceCount(); ++f) {
    auto& corners = map.cornerUv.emplace_back();
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = mesh.tail(HalfedgeId{3 * f + k}).i;
  }
  return map;
}

}  // namespace

Parametrization standIn(const Model& model, const ModelComponent& component, int q,
                        const Progress& progress, const std::string& why, bool& isKept) {
  Parametrization out;
  const std::vector<int>& sets = model.source().uvSets;
  std::optional<UvMap> old;
  if (!sets.empty()) old = model.document->existingUv(model.surface, sets.front());
  isKept = old.has_value();
  if (old) {
    out.map = mapOfComponent(component, *old);
  } else {
    ParametrizeOptions core;
    core.progress = progress;
    Result<UvMap> disk = cutDiskMap(component.mesh, core);
    out.map = disk ? std::move(*disk) : flatMap(component.mesh);
  }
  out.copyOf.assign(out.map.uv.size(), VertexId{0});
  for (std::size_t f = 0; f < out.map.cornerUv.size(); ++f) {
    for (int k = 0; k < 3; ++k) {
      const int i = out.map.cornerUv[f][static_cast<std::size_t>(k)];
      out.copyOf[static_cast<std::size_t>(i)] =
          component.mesh.tail(HalfedgeId{3 * static_cast<int>(f) + k});
    }
  }
  out.spec.q = q;
  out.spec.turning.assign(component.topology.loops.size(), 0);
  out.spec.handles.assign(static_cast<std::size_t>(2 * component.topology.genus), 0);
  out.certificate = certify(component.mesh, out.spec, out.map);
  denyCertificate(why, out.certificate);
  return out;
}

}  // namespace hgp::api
