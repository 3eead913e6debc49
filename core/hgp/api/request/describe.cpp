#include <algorithm>

#include "hgp/api/request/feature_request.h"

namespace hgp::api {
namespace {

/// Converts vertex ids of a component to those of the surface.
class Names {
 public:
  /// @param copies  per vertex of the surface, how many vertices repairs made of it
  Names(const ModelComponent& component, const std::vector<int>& copies)
      : component_(component), copies_(copies) {}

  int vertex(VertexId v) const { return component_.vertex[v].i; }
  bool isUnique(VertexId v) const { return copies_[static_cast<std::size_t>(vertex(v))] == 1; }
  /// A triangle of the surface at v.
  int triangleAt(VertexId v) const {
    return component_.face[TriMesh::face(component_.mesh.outgoing(v))].i;
  }

 private:
  const ModelComponent& component_;
  const std::vector<int>& copies_;
};

/// A vertex (surface id) that identifies the loop, or −1.
int anchorOf(const ModelComponent& component, const BoundaryLoop& loop, const Names& names) {
  for (HalfedgeId h : loop.halfedges) {
    const VertexId v = component.mesh.tail(h);
    if (names.isUnique(v)) return names.vertex(v);
  }
  return -1;
}

}  // namespace

prescription::Prescription describe(const Model& model, const std::vector<HolonomySpec>& specs) {
  prescription::Prescription out;
  out.hasCones = true;
  out.sha256 = model.sha256;
  out.vertexCount = static_cast<int>(model.source().mesh.positions.size());
  out.triangleCount = static_cast<int>(model.source().mesh.triangles.size());
  std::vector<int> copies(at(model.vertexImage.size()), 0);
  for (int v : model.vertexOrigin.raw()) ++copies[static_cast<std::size_t>(v)];
  for (std::size_t p = 0; p < specs.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const Names names(component, copies);
    out.q = specs[p].q;
    const auto told = static_cast<std::ptrdiff_t>(out.cones.size());
    for (const auto* list : {&specs[p].cones, &specs[p].corners})
      for (const ConePoint& c : *list)
        out.cones.push_back({names.vertex(c.vertex), c.k, component.mesh.position(c.vertex),
                             names.isUnique(c.vertex) ? -1 : names.triangleAt(c.vertex)});
    std::sort(out.cones.begin() + told, out.cones.end(),
              [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
    for (std::size_t j = 0; j < specs[p].turning.size(); ++j) {
      if (!specs[p].turning[j]) continue;
      out.boundaries.push_back({component.loop[LoopId{static_cast<int>(j)}].i, *specs[p].turning[j],
                                anchorOf(component, component.topology.loops[j], names)});
    }
    for (std::size_t j = 0; j < specs[p].handles.size(); ++j) {
      if (!specs[p].handles[j]) continue;
      out.handles.push_back(
          {component.generatorOffset + static_cast<int>(j), *specs[p].handles[j]});
    }
  }
  out.features = describeFeatures(model, specs);
  return out;
}

}  // namespace hgp::api
