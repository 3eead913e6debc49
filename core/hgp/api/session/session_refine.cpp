#include <algorithm>
#include <chrono>

#include "hgp/api/session/refined_model.h"
#include "hgp/api/session/session_state.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

/// Limit of steps of each refined mesh as a fraction of a run's: three refined meshes at most double the steps.
constexpr double kRefinedShare = 0.3;

/// Size of a mesh as the limit of steps counts it. The share of a refined mesh is scaled by it, so that a mesh with four
/// times the triangles does not get four times the steps.
double facesCounted(const Model& model) {
  return static_cast<double>(std::max<std::size_t>(model.source().mesh.triangles.size(),
                                                   ParametrizeOptions::kSmallSurface));
}

int certifiedCount(const std::vector<Certificate>& certificates) {
  return static_cast<int>(std::count_if(certificates.begin(), certificates.end(),
                                        [](const Certificate& c) { return c.isCertified; }));
}

std::size_t edgeCount(const std::vector<std::vector<SplitPlace>>& places) {
  std::size_t count = 0;
  for (const auto& component : places)
    for (const SplitPlace& place : component) count += place.edges.size();
  return count;
}

bool isAnyGiven(const std::vector<std::optional<int>>& handles) {
  return std::any_of(handles.begin(), handles.end(), [](const auto& r) { return r.has_value(); });
}

Note refinedNote(const RefinedFacts& facts, const Model& refined) {
  std::string reasons;
  std::vector<std::pair<std::string, std::size_t>> sums;
  for (const RefinedFacts::Place& place : facts.places) {
    const auto it = std::find_if(sums.begin(), sums.end(),
                                 [&](const auto& sum) { return sum.first == place.reason; });
    if (it == sums.end())
      sums.push_back({place.reason, place.edges.size()});
    else
      it->second += place.edges.size();
  }
  for (const auto& [reason, count] : sums)
    reasons += formatText("%s%zu %s", reasons.empty() ? "" : ", ", count, reason.c_str());
  return Note("refined", {{"edges", facts.edges},
                          {"places", reasons},
                          {"programs", facts.roundsBefore},
                          {"vertices", refined.source().mesh.positions.size()},
                          {"triangles", refined.source().mesh.triangles.size()},
                          {"verticesBefore", facts.verticesBefore},
                          {"trianglesBefore", facts.trianglesBefore}});
}

/// Whether every component was certified before it was stored.
bool hasMap(const RunRecord& run) {
  return std::all_of(run.components.begin(), run.components.end(),
                     [](const Parametrization& c) { return c.isCertified; });
}

}  // namespace

Status Session::State::solveAsPolygons(
    const std::optional<prescription::Prescription>& prescription, const SolveOptions& options) {
  auto next = std::make_unique<State>();
  if (Status taken = next->take(modelOfPolygons(*model, Note("split-as-polygons"))); !taken)
    return taken;
  if (Status done = next->solve(prescription, options); !done) return done;
  finer = next->finer ? next->finer : std::shared_ptr<State>(std::move(next));
  return Done{};
}

/// Per component, a field with the prescribed handle rotations; empty if none are prescribed.
std::vector<std::optional<FrameField>> Session::State::fieldsOfGivenHandles(const Request& request,
                                                                            const RunRecord& run) {
  std::vector<std::optional<FrameField>> fields(request.components.size());
  for (std::size_t p = 0; p < fields.size(); ++p) {
    if (!isAnyGiven(request.components[p].spec.handles)) continue;
    Result<PrescribedField> field = surfaceOf(p).field(toSpec(run.components[p].spec));
    if (field) fields[p] = std::move(field->field);
  }
  return fields;
}

Status Session::State::solveImproved(const Request& request, const SolveOptions& options,
                                     RunRecord& run) {
  if (!hasMap(run) || options.improve || options.convexPolygons) return Done{};
  SolveOptions better = options;
  better.improve.emplace();
  RunRecord again;
  again.options = run.options;
  again.isAutomatic = run.isAutomatic;
  again.notes = request.notes;
  std::shared_ptr<Solved> before = std::move(solved);
  solved.reset();
  const Status done = solveRequest(request, better, again);
  if (done && solved->stored.isCertified) {
    again.notes.push_back(Note("map-small-improved"));
    run = std::move(again);
    return Done{};
  }
  solved = std::move(before);
  return !done && done.error().code == ErrorCode::kCancelled ? done : Status(Done{});
}

/// What to try where a method found no map.
static Note wayOut(Method method) {
  if (method == Method::kAuto) return Note("refine-offered");
  return Note("method-offered", {{"method", methodName(method)}});
}

Status Session::State::solveRefined(const Request& request, const SolveOptions& options,
                                    RunRecord& run) {
  const auto start = std::chrono::steady_clock::now();
  if (!options.refines) {
    if (!hasMap(run)) run.notes.push_back(wayOut(options.method));
    return Done{};
  }
  const std::vector<std::optional<FrameField>> fields = fieldsOfGivenHandles(request, run);
  int best = certifiedCount(solved->stored.certificates);
  std::size_t last = 0;
  std::string tried;
  for (int attempt = 0; attempt < kRefinements; ++attempt) {
    std::vector<std::vector<SplitPlace>> places(model->components.size());
    for (std::size_t p = 0; p < places.size(); ++p)
      if (!solved->stored.certificates[p].isCertified)
        places[p] = placesToSplit(model->components[p].mesh, run.components[p], attempt);
    if (edgeCount(places) == last) continue;
    last = edgeCount(places);
    Result<RefinedModel> refined = refine(*model, places);
    if (!refined) return refined.error();
    Result<Request> carried = carryOver(*model, request, fields, *refined);
    if (!carried) return carried.error();
    auto next = std::make_unique<State>();
    if (Status taken = next->take(std::move(refined->model)); !taken) return taken;
    next->stepShare = kRefinedShare * facesCounted(*model) / facesCounted(*next->model);
    RunRecord again;
    again.options = run.options;
    again.isAutomatic = run.isAutomatic;
    again.notes = request.notes;
    const Status done = next->solveRequest(*carried, options, again);
    if (!done && done.error().code == ErrorCode::kCancelled) return done;
    tried +=
        formatText("%s%zu", tried.empty() ? "" : ", ", next->model->source().mesh.triangles.size());
    if (!done || certifiedCount(next->solved->stored.certificates) <= best) continue;
    best = certifiedCount(next->solved->stored.certificates);
    again.refined = std::move(refined->facts);
    for (const Parametrization& component : run.components)
      again.refined->roundsBefore += component.rounds.size();
    again.notes.push_back(refinedNote(*again.refined, *next->model));
    again.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    next->publish(again);
    finer = std::move(next);
    if (finer->solved->stored.isCertified) return Done{};
  }
  if (!finer)
    run.notes.push_back(tried.empty() ? Note("refine-nowhere")
                                      : Note("refine-in-vain", {{"triangles", tried}}));
  return Done{};
}

}  // namespace hgp::api
