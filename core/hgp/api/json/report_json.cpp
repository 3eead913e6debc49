#include <algorithm>

#include "hgp/api/json/json_text.h"
#include "hgp/api/json/spliced_text.h"
#include "hgp/api/option_words.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

Json optionsJson(const SolveOptions& o, bool isAutomatic) {
  Json json = object({{"rounds", o.maxRounds}, {"improve", nullptr}, {"refine", o.refines}});
  if (o.convexPolygons) json["convexPolygons"] = true;
  if (o.improve)
    json["improve"] =
        object({{"word", improveWord(o.improve->balance)}, {"balance", o.improve->balance}});
  json["method"] = methodName(o.method);
  json["boundary"] = boundaryName(o.boundary);
  json["scale"] = o.scale == Scale::kUnit ? "unit" : o.scale == Scale::kFit ? "fit" : "solved";
  json["frames"] = o.frames == FrameSource::kFile ? "file" : "auto";
  json["grid"] = object({{"cells", o.grid.cells},
                         {"spacing", o.grid.spacing},
                         {"mode", o.grid.mode == GridMode::kQuad ? "quad" : "tile"}});
  if (o.symmetry != Symmetry::kNone) json["symmetric"] = symmetryWord(o.symmetry);
  json["automaticCones"] = isAutomatic;
  if (isAutomatic) {
    json["q"] = o.q;
    json["coneCount"] = o.coneCount;
    json["conesFor"] = conesForName(o.conesFor);
    json["alignToCurvature"] = o.alignToCurvature;
  }
  return json;
}

Json roundJson(const Round& r) {
  return object({{"method", r.method},
                 {"constrainedTriangles", r.constrainedTriangles},
                 {"iterations", r.iterations},
                 {"solverStatus", r.solverStatus},
                 {"flipped", r.flipped},
                 {"wrongAngles", r.wrongAngles},
                 {"laplacianEnergy", r.laplacianEnergy},
                 {"seconds", r.seconds}});
}

/// The reason, with the cones that are too close to each other as its places, and what would work.
Json gridReason(const GridReport& grid, const std::vector<Where>& cones) {
  if (!grid.reason) return {};
  Note note = *grid.reason;
  std::string near;
  for (std::size_t n = 0; n < cones.size(); ++n)
    near += formatText("%s%.2f", n == 0 ? "" : ", ", grid.closest[n].cells);
  note.where = cones;
  note.values.push_back({"near", near});
  note.values.push_back({"working", grid.workingCells});
  note.values.push_back({"these", grid.workingCells > 0 && grid.needsTheseCones ? 1 : 0});
  return noteJson(note);
}

Json gridJson(const ModelComponent& component, const std::optional<GridReport>& grid) {
  if (!grid) return Json();
  std::vector<Where> cones;
  for (const ConeDistance& pair : grid->closest)
    cones.push_back({Where::Kind::kEdge, pair.a.i, pair.b.i});
  toSurfaceIds(component, cones);
  Json closest = Json::array();
  for (std::size_t n = 0; n < cones.size(); ++n)
    closest.push_back(object({{"vertices", Json::array({cones[n].id, cones[n].other})},
                              {"cells", grid->closest[n].cells}}));
  Json attempts = Json::array();
  for (const GridAttempt& a : grid->attempts)
    attempts.push_back(
        object({{"method", a.method}, {"density", a.factor}, {"turnedTriangles", a.turned}}));
  return object({{"aligned", grid->isAligned},
                 {"cells", grid->cells},
                 {"spacing", grid->spacing},
                 {"cellsPerCone", grid->cellsPerCone},
                 {"integers", grid->integers},
                 {"attempts", std::move(attempts)},
                 {"reason", gridReason(*grid, cones)},
                 {"closestCones", std::move(closest)},
                 {"workingCells", grid->workingCells}});
}

/// The verifier's measurements that an improvement changes.
Json distortionJson(const DistortionFacts& d) {
  return object({{"meanMu", d.meanMu},
                 {"p95Mu", d.p95Mu},
                 {"rmsLogArea", d.rmsLogArea},
                 {"symmetricDirichlet", d.symmetricDirichlet}});
}

Json descentJson(const DescentFacts& facts) {
  Json steps = Json::array();
  for (const ImproveStep& step : facts.steps)
    steps.push_back(object({{"excess", step.excess}, {"length", step.length}}));
  return object({{"kept", facts.isKept},
                 {"outcome", outcomeName(facts.outcome)},
                 {"steps", std::move(steps)},
                 {"before", distortionJson(facts.before)},
                 {"after", distortionJson(facts.after)}});
}

Json improvementJson(const ImprovementFacts& facts) {
  Json json = descentJson(facts);
  json["balance"] = facts.asked.balance;
  json["onGrid"] = facts.onGrid ? descentJson(*facts.onGrid) : Json();
  return json;
}

const char* weightsName(WeightKind kind) {
  return kind == WeightKind::kCotangent ? "cotangent" : "mean-value";
}

/// Whether Theorem 6.1 applies to the map, and if not, why.
void addTheorem(Json& json, const HarmonicFacts& harmonic, const Certificate& certificate) {
  std::string reason;
  if (!certificate.isCertified) {
    reason = "the map is not certified";
  } else if (harmonic.violated > 0) {
    reason = formatText("%d of %d harmonic rows are violated by more than %.0e", harmonic.violated,
                        harmonic.rows, kHarmonicTolerance);
  }
  json["theorem61"] = reason.empty() ? "applies" : "silent";
  if (reason.empty())
    reason = formatText(
        "harmonic with %s weights, and cones, turnings and the triangles at cones "
        "and boundary are as it asks",
        weightsName(harmonic.weights));
  json["theorem61Reason"] = reason;
}

Json componentJson(const ModelComponent& component, const Parametrization& run,
                   const HarmonicFacts& harmonic, const Certificate& certificate) {
  Json rounds = Json::array(), times = Json::array();
  for (const Round& r : run.rounds) rounds.push_back(roundJson(r));
  for (const StageTime& t : run.times) {
    times.push_back(object({{"stage", stageName(t.stage)}, {"seconds", t.seconds}}));
  }
  std::vector<Where> strained;
  for (FaceId f : run.strained) strained.push_back({Where::Kind::kFace, f.i});
  toSurfaceIds(component, strained);
  Json json = object({{"certifiedBeforeStoring", run.isCertified},
                      {"usable", run.isUsable},
                      {"harmonic", object({{"weights", weightsName(harmonic.weights)},
                                           {"rows", harmonic.rows},
                                           {"violated", harmonic.violated},
                                           {"largestResidual", harmonic.largestResidual}})},
                      {"cones", run.spec.cones.size()},
                      {"rounds", std::move(rounds)},
                      {"times", std::move(times)},
                      {"improvement", run.improvement ? improvementJson(*run.improvement) : Json()},
                      {"conflict", whereJson(strained)},
                      {"grid", gridJson(component, run.grid)},
                      {"notes", notesJson(run.notes, component)}});
  addTheorem(json, harmonic, certificate);
  return json;
}

Json refinedJson(const RefinedFacts& facts, const Model& model) {
  Json where = Json::array();
  for (const RefinedFacts::Place& place : facts.places)
    where.push_back(object({{"reason", place.reason},
                            {"component", place.component},
                            {"count", place.edges.size()},
                            {"edges", whereJson(place.edges)}}));
  return object({{"edges", facts.edges},
                 {"vertices", model.source().mesh.positions.size()},
                 {"triangles", model.source().mesh.triangles.size()},
                 {"roundsBefore", facts.roundsBefore},
                 {"where", std::move(where)}});
}

constexpr const char* kComponentsHere = "(components)";
constexpr const char* kConesHere = "(cones)";
constexpr const char* kCertificateHere = "(certificate)";

}  // namespace

std::string reportText(const Model& model, const RunRecord& run,
                       const std::vector<Certificate>& certificates, const OutsideFacts& outside,
                       const std::string& cones) {
  Json json = object({{"format", "hgp-report"}, {"version", 1}});
  json["program"] = object({{"name", "hgp"}, {"version", version()}});
  json["certified"] = areCertified(certificates);
  json["input"] = object({{"name", model.fileName},
                          {"format", model.document->format()},
                          {"bytes", model.byteCount},
                          {"sha256", model.sha256},
                          {"surface", model.surface},
                          {"vertices", model.source().mesh.positions.size()},
                          {"triangles", model.source().mesh.triangles.size()}});
  if (run.refined) {
    json["input"]["vertices"] = run.refined->verticesBefore;
    json["input"]["triangles"] = run.refined->trianglesBefore;
  }
  if (model.written) json["input"]["vertices"] = model.written->verticesBefore;
  json["refined"] = run.refined ? refinedJson(*run.refined, model) : Json();
  json["repairsWritten"] = model.written
                               ? object({{"facesTurned", model.written->facesTurned},
                                         {"verticesCopied", model.written->verticesCopied}})
                               : Json();
  json["options"] = optionsJson(run.options, run.isAutomatic);
  json["seconds"] = run.seconds;
  Notes notes = model.source().notes;
  addNotes(notes, model.notes);
  addNotes(notes, run.notes);
  json["notes"] = notesJson(notes);
  json["components"] = kComponentsHere;
  json["cones"] = kConesHere;
  json["certificate"] = kCertificateHere;
  const auto component = [&](std::size_t p) {
    return componentJson(model.components[p], run.components[p], run.harmonic[p], certificates[p]);
  };
  const SplicedDocument document{
      std::move(json),
      {arrayMember(kComponentsHere, run.components.size(), component),
       textMember(kConesHere, cones),
       documentMember(kCertificateHere,
                      certificateDocument(model, certificates, outside, -1, {}))}};
  return document.text();
}

std::string certificateOf(const std::string& report) { return lastDocument(report, "certificate"); }

}  // namespace hgp::api
