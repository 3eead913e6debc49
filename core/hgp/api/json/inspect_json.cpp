#include "hgp/api/json/json_text.h"
#include "hgp/api/json/json_values.h"
#include "hgp/api/model/mirrors.h"
#include "hgp/api/session.h"
#include "hgp/features/creases.h"
#include "hgp/mesh/finite.h"
#include "hgp/mesh/geometry.h"

namespace hgp::api {
namespace {

constexpr std::size_t kMaxPlaces = 1000;

Json surfacesJson(const Model& model) {
  Json out = Json::array();
  const auto& surfaces = model.document->surfaces();
  const std::vector<io::Placements> places = model.document->placements();
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    const io::Surface& s = surfaces[i];
    out.push_back(object({{"index", i},
                          {"name", s.name},
                          {"vertices", s.mesh.positions.size()},
                          {"storedVertices", s.storedVertexCount},
                          {"welded", s.isWelded},
                          {"triangles", s.mesh.triangles.size()},
                          {"uvSets", s.uvSets},
                          {"notes", notesJson(s.notes)}}));
    if (i < places.size()) {
      out.back()["uses"] = places[i].count;
      out.back()["mirrored"] = places[i].isMirrored;
    }
  }
  return out;
}

Json defectsJson(const Model& model) {
  Json out = Json::array();
  for (const Defect& defect : model.defects) {
    std::vector<Where> where = defect.where;
    if (where.size() > kMaxPlaces) where.resize(kMaxPlaces);
    const auto vertex = [&](std::int64_t& v) {
      const MeshVertexId id{static_cast<int>(v)};
      if (model.vertexOrigin.has(id)) v = model.vertexOrigin[id].i;
    };
    for (Where& w : where) {
      if (w.kind == Where::Kind::kVertex || w.kind == Where::Kind::kEdge) vertex(w.id);
      if (w.kind == Where::Kind::kEdge) vertex(w.other);
      const MeshFaceId face{static_cast<int>(w.id)};
      if (w.kind == Where::Kind::kFace && model.faceOrigin.has(face))
        w.id = model.faceOrigin[face].i;
    }
    out.push_back(object({{"kind", defectName(defect.kind)},
                          {"fatal", isFatal(defect.kind, !model.unusable)},
                          {"count", defect.where.size()},
                          {"where", whereJson(where, kMaxPlaces)}}));
  }
  return out;
}

Json loopsJson(const ModelComponent& component) {
  Json out = Json::array();
  if (component.topology.loops.empty()) return out;
  const Geometry geometry = computeGeometry(component.mesh);
  for (std::size_t j = 0; j < component.topology.loops.size(); ++j) {
    const auto& halfedges = component.topology.loops[j].halfedges;
    double length = 0, turning = 0;
    for (HalfedgeId h : halfedges) {
      length += geometry.length[h] * geometry.unit;
      turning += curvature(component.mesh, geometry, component.mesh.tail(h));
    }
    const VertexId first = component.mesh.tail(halfedges.front());
    out.push_back(object({{"loop", component.loop[LoopId{static_cast<int>(j)}].i},
                          {"vertices", halfedges.size()},
                          {"anchor", component.vertex[first].i},
                          {"length", length},
                          {"turningAngle", turning}}));
  }
  return out;
}

Json componentsJson(const Model& model) {
  Json out = Json::array();
  for (std::size_t p = 0; p < model.components.size(); ++p) {
    const ModelComponent& component = model.components[p];
    out.push_back(object(
        {{"component", p},
         {"vertices", component.mesh.vertexCount() - component.topology.isolatedVertexCount},
         {"edges", component.mesh.edgeCount()},
         {"triangles", component.mesh.faceCount()},
         {"eulerCharacteristic", component.topology.eulerCharacteristic},
         {"genus", component.topology.genus},
         {"handleGenerators",
          object({{"first", component.generatorOffset}, {"count", 2 * component.topology.genus}})},
         {"boundaryLoops", loopsJson(component)}}));
  }
  return out;
}

Json featuresJson(const Model& model) {
  int creases = 0, chains = 0, rims = 0;
  for (const ModelComponent& component : model.components) {
    const std::vector<EdgeId> edges = findCreases(component.mesh);
    creases += static_cast<int>(edges.size());
    chains += countRuns(component.mesh, edges);
    for (const BoundaryLoop& loop : component.topology.loops)
      rims += static_cast<int>(loop.halfedges.size());
  }
  return object({{"degrees", kCreaseDegrees},
                 {"creaseEdges", creases},
                 {"creaseChains", chains},
                 {"rimEdges", rims}});
}

Json mirrorsJson(const Model& model) {
  Json out = Json::array();
  for (const ModelMirror& mirror : findMirrors(model))
    out.push_back(object({{"name", mirror.plane.name},
                          {"normal", mirror.plane.normal},
                          {"offset", mirror.plane.offset},
                          {"edgesIn", mirror.inPlane},
                          {"edgesAcross", mirror.across},
                          {"distance", mirror.distance}}));
  return out;
}

Json budgetJson(const ComponentCheck& check) {
  if (!check.budget) return Json();
  const BudgetReport& b = *check.budget;
  return object(
      {{"have", b.have}, {"need", b.need}, {"left", b.need - b.have}, {"openLoops", b.openLoops}});
}

}  // namespace

std::string inspectText(const Model& model) {
  Json json = object({{"format", "hgp-inspect"}, {"version", 1}, {"usable", !model.unusable}});
  json["file"] = object({{"name", model.fileName},
                         {"format", model.document->format()},
                         {"bytes", model.byteCount},
                         {"sha256", model.sha256}});
  json["surfaces"] = surfacesJson(model);
  json["surface"] = model.surface;
  json["vertices"] = model.mesh.positions.size();
  json["triangles"] = model.mesh.triangles.size();
  if (!model.unusable) {
    const Topology& t = model.topology;
    json["eulerCharacteristic"] = t.eulerCharacteristic;
    json["genus"] = t.genus;
    json["boundaryLoops"] = t.loops.size();
    json["isolatedVertices"] = t.isolatedVertexCount;
    json["components"] = componentsJson(model);
    json["features"] = featuresJson(model);
    json["mirrors"] = mirrorsJson(model);
  }
  json["diagonal"] = diagonal(finiteBoxOf(model.mesh.positions));
  json["defects"] = defectsJson(model);
  json["notes"] = notesJson(model.notes);
  if (model.unusable) json["error"] = failureJson(*model.unusable);
  return textOf(json);
}

std::string checkText(const Model& model, const Request& request,
                      const std::vector<ComponentCheck>& checks) {
  bool isValid = true;
  Json components = Json::array();
  for (std::size_t p = 0; p < checks.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const HolonomySpec& spec = request.components[p].spec;
    isValid = isValid && !checks[p].refusal;
    Json entry = object({{"component", p},
                         {"valid", !checks[p].refusal},
                         {"automatic", checks[p].isAutomatic},
                         {"genus", component.topology.genus},
                         {"boundaryLoops", component.loop.size()},
                         {"cones", spec.cones.size()},
                         {"budget", budgetJson(checks[p])}});
    entry["warnings"] =
        checks[p].budget ? notesJson(checks[p].budget->warnings, component) : Json::array();
    if (checks[p].refusal) entry["error"] = failureJson(*checks[p].refusal);
    components.push_back(std::move(entry));
  }
  Json json = object({{"format", "hgp-check"},
                      {"version", 1},
                      {"valid", isValid},
                      {"q", request.q},
                      {"components", std::move(components)},
                      {"notes", notesJson(request.notes)}});
  return textOf(json);
}

std::string checkText(const Failure& refusal) {
  return textOf(object({{"format", "hgp-check"},
                        {"version", 1},
                        {"valid", false},
                        {"components", Json::array()},
                        {"notes", Json::array()},
                        {"error", failureJson(refusal)}}));
}

std::string errorJson(const Failure& failure) {
  Json json = object({{"format", "hgp-error"}, {"version", 1}});
  json.update(failureJson(failure));
  return textOf(json);
}

}  // namespace hgp::api
