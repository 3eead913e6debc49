#include "hgp/api/session/refined_model.h"

#include <algorithm>
#include <map>

#include "hgp/api/model/load_model.h"
#include "hgp/base/check.h"
#include "hgp/base/turns.h"
#include "hgp/io/polygon/polygon_document.h"

namespace hgp::api {
namespace {

VertexPair ordered(int a, int b) { return a < b ? VertexPair{a, b} : VertexPair{b, a}; }

/// The surface vertices at the ends of a halfedge, as stored in its triangle.
VertexPair storedEnds(const Model& model, const ModelComponent& component, HalfedgeId h) {
  VertexPair ends{};
  const auto& triangles = model.source().mesh.triangles;
  for (std::size_t i = 0; i < 2; ++i) {
    const HalfedgeId at = i == 0 ? h : TriMesh::next(h);
    const SurfaceCornerId corner = component.corner[at];
    ends[i] = triangles[hgp::at(corner.i / 3)][hgp::at(corner.i % 3)];
  }
  return ends;
}

Failure tangled() {
  return {
      ErrorCode::kUnsupported,
      "refine",
      "this mesh and its refinement are repaired differently; write the repaired mesh, then refine",
      {}};
}

/// Transfers the prescription of one component to its refinement.
class Carrier {
 public:
  Carrier(const Model& before, const RefinedModel& refined, std::size_t p)
      : refined_(refined), old_(before.components[p]), new_(refined.model.components[p]) {
    for (VertexId v : new_.mesh.vertices()) vertexAt_.emplace(new_.vertex[v].i, v);
  }

  Result<ComponentRequest> carry(const ComponentRequest& request,
                                 const std::optional<FrameField>& field) {
    ComponentRequest out;
    out.isAutomatic = request.isAutomatic;
    out.refusal = request.refusal;
    out.spec.q = request.spec.q;
    if (!request.spec.features.empty() && !carryFeatures(request.spec, out.spec)) return tangled();
    if (out.isAutomatic) return out;
    if (!carryCones(request.spec.cones, out.spec.cones)) return tangled();
    if (!carryCones(request.spec.corners, out.spec.corners)) return tangled();
    if (!carryTurning(request.spec, out.spec)) return tangled();
    out.spec.handles.resize(request.spec.handles.size());
    const auto& handles = request.spec.handles;
    if (std::none_of(handles.begin(), handles.end(), [](const auto& r) { return r.has_value(); }))
      return out;
    if (!field || !findOldHalfedges()) return tangled();
    const std::vector<DualLoop> loops = handleGenerators(new_.mesh);
    if (loops.size() != handles.size()) return tangled();
    for (std::size_t i = 0; i < loops.size(); ++i) {
      int sum = 0;
      for (HalfedgeId h : loops[i].crossed)
        if (const HalfedgeId old = oldHalfedge(h); old.isValid()) sum += field->matching[old];
      out.spec.handles[i] = reduceTurn(sum, out.spec.q);
    }
    return out;
  }

 private:
  bool carryCones(const std::vector<ConePoint>& from, std::vector<ConePoint>& to) const {
    for (const ConePoint& cone : from) {
      const auto v = vertexAt_.find(old_.vertex[cone.vertex].i);
      if (v == vertexAt_.end()) return false;
      to.push_back({v->second, cone.k});
    }
    return true;
  }

  bool carryTurning(const HolonomySpec& from, HolonomySpec& to) {
    to.turning.resize(new_.topology.loops.size());
    for (std::size_t j = 0; j < from.turning.size(); ++j) {
      if (!from.turning[j]) continue;
      const VertexId on = old_.mesh.tail(old_.topology.loops[j].halfedges.front());
      const auto v = vertexAt_.find(old_.vertex[on].i);
      bool isFound = false;
      for (std::size_t i = 0; i < new_.topology.loops.size() && v != vertexAt_.end(); ++i) {
        const auto& loop = new_.topology.loops[i].halfedges;
        if (std::none_of(loop.begin(), loop.end(),
                         [&](HalfedgeId h) { return new_.mesh.tail(h) == v->second; }))
          continue;
        to.turning[i] = from.turning[j];
        isFound = true;
      }
      if (!isFound) return false;
    }
    return true;
  }

  /// Features stay where they were, in halves where they are split.
  bool carryFeatures(const HolonomySpec& from, HolonomySpec& to) {
    // By surface vertices, of which repairs may have made copies.
    std::multimap<VertexPair, EdgeId> edgesAt;
    for (EdgeId e : new_.mesh.edges()) edgesAt.emplace(surfaceEnds(new_, e), e);
    const std::map<VertexPair, int> midpoints = findMidpoints();
    for (EdgeId e : from.features) {
      const VertexPair ends = surfaceEnds(old_, e);
      std::vector<VertexPair> parts{ends};
      if (const auto middle = midpoints.find(ends); middle != midpoints.end())
        parts = {ordered(ends[0], middle->second), ordered(ends[1], middle->second)};
      for (const VertexPair& part : parts) {
        const auto [first, last] = edgesAt.equal_range(part);
        if (first == last) return false;
        for (auto there = first; there != last; ++there) to.features.push_back(there->second);
      }
    }
    std::sort(to.features.begin(), to.features.end());
    to.features.erase(std::unique(to.features.begin(), to.features.end()), to.features.end());
    return true;
  }

  static VertexPair surfaceEnds(const ModelComponent& component, EdgeId e) {
    const HalfedgeId h = component.mesh.halfedge(e);
    return ordered(component.vertex[component.mesh.tail(h)].i,
                   component.vertex[component.mesh.head(h)].i);
  }

  /// The midpoint of each edge that was split, by surface vertices after welds.
  std::map<VertexPair, int> findMidpoints() const {
    const Model& model = refined_.model;
    const auto standIn = [&](int stored) {
      const MeshVertexId image = model.vertexImage[SurfaceVertexId{stored}];
      return image.isValid() ? model.vertexOrigin[image].i : stored;
    };
    std::map<VertexPair, int> midpoints;
    const int count = refined_.facts.verticesBefore;
    for (std::size_t i = 0; i < refined_.parents.size(); ++i) {
      const VertexPair& ends = refined_.parents[i];
      midpoints.emplace(ordered(standIn(ends[0]), standIn(ends[1])),
                        standIn(count + static_cast<int>(i)));
    }
    return midpoints;
  }

  bool findOldHalfedges() {
    for (HalfedgeId h : old_.mesh.halfedges()) {
      const VertexPair ends{old_.vertex[old_.mesh.tail(h)].i, old_.vertex[old_.mesh.head(h)].i};
      if (!oldAt_.emplace(ends, h).second) return false;
    }
    return true;
  }

  /// The halfedge of the original component on which h lies; invalid for an h inside a triangle.
  HalfedgeId oldHalfedge(HalfedgeId h) const {
    int a = new_.vertex[new_.mesh.tail(h)].i;
    int b = new_.vertex[new_.mesh.head(h)].i;
    const int count = refined_.facts.verticesBefore;
    if (a >= count && b >= count) return {};
    if (a >= count || b >= count) {
      const VertexPair ends = refined_.parents[static_cast<std::size_t>(std::max(a, b) - count)];
      const int known = std::min(a, b);
      if (known != ends[0] && known != ends[1]) return {};
      const int other = known == ends[0] ? ends[1] : ends[0];
      (a >= count ? a : b) = other;
    }
    const auto it = oldAt_.find({a, b});
    return it == oldAt_.end() ? HalfedgeId() : it->second;
  }

  const RefinedModel& refined_;
  const ModelComponent &old_, &new_;
  std::map<int, VertexId> vertexAt_;
  std::map<VertexPair, HalfedgeId> oldAt_;
};

}  // namespace

Result<Model> modelOfPolygons(const Model& model, Note lost) {
  io::PolygonFile file;
  file.polygons.positions = model.source().mesh.positions;
  for (const auto& t : model.source().mesh.triangles) {
    file.polygons.cornerVertex.insert(file.polygons.cornerVertex.end(), t.begin(), t.end());
    file.polygons.start.push_back(static_cast<std::uint32_t>(file.polygons.cornerVertex.size()));
  }
  file.notes = model.source().notes;
  file.notes.push_back(std::move(lost));
  file.storedVertexCount = model.source().storedVertexCount;
  Result<io::DocumentPtr> document =
      io::PolygonDocument::make(model.document->format(), std::move(file));
  if (!document) return document.error();
  LoadOptions load = model.load;
  load.surface = 0;
  Result<Model> out = modelOfDocument(std::move(*document), load);
  if (!out) return out;
  out->fileName = model.fileName;
  out->sha256 = model.sha256;
  out->byteCount = model.byteCount;
  return out;
}

bool canRefine(const Model& model) { return model.document->refined(model.surface, {}).hasValue(); }

Result<RefinedModel> refine(const Model& model,
                            const std::vector<std::vector<SplitPlace>>& places) {
  std::vector<VertexPair> edges;
  RefinedFacts facts;
  for (std::size_t p = 0; p < places.size(); ++p) {
    const ModelComponent& component = model.components[p];
    for (const SplitPlace& place : places[p]) {
      RefinedFacts::Place told{place.reason, static_cast<int>(p), {}};
      for (EdgeId e : place.edges) {
        const HalfedgeId h = component.mesh.halfedge(e), twin = component.mesh.twin(h);
        const VertexPair ends = storedEnds(model, component, h);
        edges.push_back(ordered(ends[0], ends[1]));
        told.edges.push_back({Where::Kind::kEdge, edges.back()[0], edges.back()[1]});
        if (!twin.isValid()) continue;
        const VertexPair there = storedEnds(model, component, twin);
        edges.push_back(ordered(there[0], there[1]));
      }
      facts.places.push_back(std::move(told));
    }
  }
  const MeshData& before = model.source().mesh;
  facts.verticesBefore = static_cast<int>(before.positions.size());
  facts.trianglesBefore = static_cast<int>(before.triangles.size());
  Result<io::DocumentPtr> document = model.document->refined(model.surface, edges);
  if (!document) return document.error();
  LoadOptions load = model.load;
  load.surface = model.surface;
  Result<Model> loaded = modelOfDocument(std::move(*document), load);
  if (!loaded) return loaded.error();
  if (loaded->unusable || loaded->components.size() != model.components.size()) return tangled();
  if (!loaded->written) loaded->written = model.written;
  RefinedModel out{std::move(*loaded), splitEdges(before, std::move(edges)).parents, {}};
  facts.edges = static_cast<int>(out.parents.size());
  out.facts = std::move(facts);
  out.model.fileName = model.fileName;
  out.model.sha256 = model.sha256;
  out.model.byteCount = model.byteCount;
  if (out.model.source().mesh.positions.size() != before.positions.size() + out.parents.size())
    return tangled();
  return out;
}

Result<Request> carryOver(const Model& before, const Request& request,
                          const std::vector<std::optional<FrameField>>& fields,
                          const RefinedModel& refined) {
  Request out;
  out.q = request.q;
  out.notes = request.notes;
  for (std::size_t p = 0; p < request.components.size(); ++p) {
    Result<ComponentRequest> component =
        Carrier(before, refined, p).carry(request.components[p], fields[p]);
    if (!component) return component.error();
    out.components.push_back(std::move(*component));
  }
  return out;
}

}  // namespace hgp::api
