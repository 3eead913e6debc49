// From the maps of all components to a result: stored, verified as stored, described.
#include "hgp/api/session/session_state.h"
#include "hgp/api/stored/convex_polygons.h"
#include "hgp/base/parallel.h"
#include "hgp/io/cone_files.h"

namespace hgp::api {
namespace {

/// Measures harmonicity on the stored values of every component.
std::vector<HarmonicFacts> harmonicity(const Model& model, const std::vector<ComponentMap>& maps,
                                       const UvMap& stored) {
  const bool isFloat = model.document->uvPrecision() == io::UvPrecision::kFloat32;
  std::vector<HarmonicFacts> out;
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const ModelComponent& component = model.components[p];
    const UvMap map = mapOfComponent(component, stored);
    std::vector<VertexId> cones;
    for (const ConePoint& c : maps[p].spec.cones) cones.push_back(c.vertex);
    out.push_back(measureHarmonicity(component.mesh, computeGeometry(component.mesh), map,
                                     maps[p].spec.q, cones, isFloat ? gridStep(map) : 0.0));
  }
  return out;
}

/// Whether the map before rounding must be kept: if rotations have no exact coefficients, seams cannot be exact in
/// float32, and formats that store doubles are written from the unrounded map.
bool needsOwnNumbers(const Model& model, int q) {
  return 4 % q != 0 && model.document->uvPrecision() == io::UvPrecision::kFloat32;
}

StoredMap storedWith(const Model& model, const SolveOptions& options,
                     std::vector<ComponentMap>& maps) {
  if (!options.convexPolygons) return storeMap(model, maps, options.scale);
  const io::PolygonsView polygons = model.document->polygons(model.surface);
  makePolygonsConvex(model, polygons, maps);
  StoredMap stored = storeMap(model, maps, options.scale);
  denyNotConvex(model, polygons, stored.map, stored.certificates);
  stored.isCertified = areCertified(stored.certificates);
  return stored;
}

}  // namespace

/// Converts the result to the flat arrays that the session returns.
void Session::State::flatten(Solved& result) const {
  const StoredMap& stored = result.stored;
  result.uv.reserve(2 * stored.map.uv.size());
  result.cornerToUv.reserve(3 * stored.map.cornerUv.size());
  for (const Vec2& p : stored.map.uv) result.uv.insert(result.uv.end(), p.begin(), p.end());
  for (const auto& t : stored.map.cornerUv) {
    for (int i : t) result.cornerToUv.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t p = 0; p < model->components.size(); ++p) {
    for (const MeasuredSeam& s : stored.certificates[p].seams.seams) {
      const SeamEnds ends = seamEnds(model->components[p], stored.map, s.edge);
      result.seams.push_back({{ends.a[0], ends.a[1]}, {ends.b[0], ends.b[1]}, s.r});
    }
  }
}

void Session::State::storeMaps(std::vector<ComponentMap> maps, int q, const SolveOptions& options,
                               bool areAligned, RunRecord& run) {
  std::vector<HolonomySpec> specs;
  specs.reserve(maps.size());
  for (const ComponentMap& component : maps) specs.push_back(toSpec(component.spec));
  Solved result;
  result.isAligned = areAligned;
  result.stored = storedWith(*model, options, maps);
  run.notes.insert(run.notes.end(), result.stored.notes.begin(), result.stored.notes.end());
  const auto describeCones = [&] {
    result.prescription = describe(*model, specs);
    result.cones = prescription::writeConesJson(result.prescription);
  };
  parallelInvoke({[&] { run.harmonic = harmonicity(*model, maps, result.stored.map); },
                  [&] { flatten(result); }, describeCones});
  if (!needsOwnNumbers(*model, q)) {
    for (ComponentMap& component : maps) {  // the uv are in `stored`
      component.map = {};
      component.copyOf = {};
    }
  }
  result.components = std::move(maps);
  result.options = options;
  result.options.progress = nullptr;
  solved = std::make_shared<Solved>(std::move(result));
  certificate.clear();
}

void Session::State::publish(const RunRecord& run) {
  solved->report = reportText(*model, run, solved->stored.certificates,
                              measureOutside(*model, solved->stored.map), solved->cones);
}

}  // namespace hgp::api
