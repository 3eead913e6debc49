#include <algorithm>

#include "hgp/api/request.h"

namespace hgp::api {

io::Prescription describe(const Model& model, const std::vector<HolonomySpec>& specs) {
  io::Prescription out;
  out.hasCones = true;
  out.sha256 = model.sha256;
  out.vertexCount = static_cast<int>(model.source().mesh.positions.size());
  out.triangleCount = static_cast<int>(model.source().mesh.triangles.size());
  for (std::size_t p = 0; p < specs.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const auto surfaceVertex = [&](VertexId v) {
      const int inMesh = component.vertexOrigin[static_cast<std::size_t>(v.i)];
      return model.vertexOrigin[static_cast<std::size_t>(inMesh)];
    };
    out.q = specs[p].q;
    const auto told = static_cast<std::ptrdiff_t>(out.cones.size());
    for (const ConePoint& c : specs[p].cones) {
      out.cones.push_back({surfaceVertex(c.vertex), c.k, component.mesh.position(c.vertex)});
    }
    std::sort(out.cones.begin() + told, out.cones.end(),
              [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
    for (std::size_t j = 0; j < specs[p].turning.size(); ++j) {
      if (!specs[p].turning[j]) continue;
      const HalfedgeId first = component.topology.loops[j].halfedges.front();
      out.boundaries.push_back({component.loopOrigin[j], *specs[p].turning[j],
                                surfaceVertex(component.mesh.tail(first))});
    }
    for (std::size_t j = 0; j < specs[p].handles.size(); ++j) {
      if (!specs[p].handles[j]) continue;
      out.handles.push_back(
          {component.generatorOffset + static_cast<int>(j), *specs[p].handles[j]});
    }
  }
  return out;
}

}  // namespace hgp::api
