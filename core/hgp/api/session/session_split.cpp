// Solves along features, on a surface with split edges where the given one has no map.
#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "hgp/api/session/session_state.h"
#include "hgp/api/session/split_model.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

std::vector<char> withoutMap(const std::vector<Certificate>& certificates) {
  std::vector<char> isOpen;
  isOpen.reserve(certificates.size());
  for (const Certificate& c : certificates) isOpen.push_back(!c.isCertified);
  return isOpen;
}

int countOf(const std::vector<Certificate>& certificates) {
  return static_cast<int>(std::count_if(certificates.begin(), certificates.end(),
                                        [](const Certificate& c) { return c.isCertified; }));
}

/// Ids of a split surface mean nothing to its user.
Failure withoutPlaces(Failure failure) {
  failure.where.clear();
  return failure;
}

Note splitNote(const RefinedFacts& facts, const Model& refined, bool crossesPlane) {
  return Note(crossesPlane ? "symmetric-split" : "features-split",
              {{"edges", facts.edges},
               {"vertices", refined.source().mesh.positions.size()},
               {"triangles", refined.source().mesh.triangles.size()},
               {"verticesBefore", facts.verticesBefore},
               {"trianglesBefore", facts.trianglesBefore}});
}

bool isFinal(const Status& done) {
  return !done &&
         (done.error().code == ErrorCode::kCancelled || done.error().code == ErrorCode::kUsage);
}

std::size_t roundsOf(const RunRecord& run) {
  std::size_t rounds = 0;
  for (const Parametrization& component : run.components) rounds += component.rounds.size();
  return rounds;
}

}  // namespace

/// Solves on the split surface, with its facts and a note in `run`.
Result<std::shared_ptr<Session::State>> Session::State::solveOn(SplitModel& made,
                                                                const SolveOptions& options,
                                                                RunRecord& run) {
  auto next = std::make_shared<State>();
  if (Status taken = next->take(std::move(made.refined->model)); !taken) return taken.error();
  Status done = next->solveRequest(*made.carried, options, run);
  if (done) done = next->solveWithWorkingCells(options, run);
  if (!done) return isFinal(done) ? done.error() : withoutPlaces(done.error());
  run.refined = std::move(made.facts);
  run.notes.push_back(splitNote(*run.refined, *next->model, made.crossesPlane));
  return next;
}

Status Session::State::solveSplit(const Request& request, const SolveOptions& options,
                                  RunRecord& run) {
  const auto start = std::chrono::steady_clock::now();
  const bool mustSplit = isCrowded(*model, request);
  std::vector<char> isOpen(model->components.size(), 1);
  Status first = Done{};
  int best = -1;
  if (!mustSplit) {
    first = solveRequest(request, options, run);
    if (first) first = solveWithWorkingCells(options, run);
    if (isFinal(first) || (first && solved->stored.isCertified)) return first;
    if (first) isOpen = withoutMap(solved->stored.certificates);
    if (first) best = countOf(solved->stored.certificates);
  }
  std::size_t rounds = roundsOf(run), last = model->source().mesh.triangles.size();
  std::string tried;
  for (const Splits splits : kAllSplits) {
    SplitModel made(*model, request);
    const Status split = made.split(splits, isOpen);
    const std::size_t size = made.model->source().mesh.triangles.size();
    if (!split && first && best < 0) first = split.error();
    const bool isTooLarge = splits != Splits::kCrowded && size > kLargestRefinement;
    if (!split || !made.refined || size == last || isTooLarge) continue;
    last = size;
    RunRecord again;
    again.options = run.options;
    again.isAutomatic = run.isAutomatic;
    again.notes = request.notes;
    Result<std::shared_ptr<State>> next = solveOn(made, options, again);
    if (!next && isFinal(next.error())) return next.error();
    tried += (tried.empty() ? "" : ", ") + std::to_string(size);
    const std::size_t before = std::exchange(rounds, rounds + roundsOf(again));
    if (!next && first && best < 0) first = next.error();
    if (!next) continue;
    const std::vector<Certificate>& certificates = (*next)->solved->stored.certificates;
    if (mustSplit) isOpen = withoutMap(certificates);
    if (countOf(certificates) <= best) continue;
    best = countOf(certificates);
    again.refined->roundsBefore = before;
    again.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    (*next)->publish(again);
    finer = std::move(*next);
    if (finer->solved->stored.isCertified) break;
  }
  if (!finer && first && !tried.empty())
    run.notes.push_back(Note("features-split-in-vain", {{"triangles", tried}}));
  HGP_CHECK(finer || !mustSplit || !first, "a surface without splits is left without a map");
  return finer ? Status(Done{}) : first;
}

}  // namespace hgp::api
