// Solves along features, on a surface with split edges where the given one has no map.
#include <algorithm>
#include <chrono>
#include <string>
#include <tuple>
#include <utility>

#include "hgp/api/session/session_state.h"
#include "hgp/api/session/split_model.h"
#include "hgp/base/check.h"

namespace hgp::api {
namespace {

/// Whether lines do not stay apart on the grid that was asked for, or triangles are reversed there: they may have no room.
bool isWithoutGrid(const Parametrization& component) {
  const std::optional<GridReport>& grid = component.grid;
  return grid && !grid->isAligned && grid->reason && grid->reason->code == "features-no-integers";
}

/// What a run reached.
struct Reached {
  std::vector<char> isOpen;  ///< per component: has no map, or none on the grid that was asked for
  int certified = -1, aligned = -1, advised = -1;  ///< components; -1 without a run

  bool isWhole() const { return std::find(isOpen.begin(), isOpen.end(), 1) == isOpen.end(); }
  bool hasAllMaps() const { return certified == static_cast<int>(isOpen.size()); }
  /// Advice alone is no reason to split the edges of a mesh that has a map as it is.
  bool isMoreThan(const Reached& other, bool countsAdvice) const {
    const auto reached = std::tie(certified, aligned),
               before = std::tie(other.certified, other.aligned);
    return reached > before || (countsAdvice && reached == before && advised > other.advised);
  }
};

Reached reachedBy(const std::vector<Certificate>& certificates, const RunRecord& run) {
  Reached out{{}, 0, 0, 0};
  for (std::size_t c = 0; c < certificates.size(); ++c) {
    const bool isCertified = certificates[c].isCertified;
    const bool isAligned = c >= run.components.size() || !isWithoutGrid(run.components[c]);
    out.certified += isCertified ? 1 : 0;
    out.aligned += isCertified && isAligned ? 1 : 0;
    // Or a number of cells is known that works.
    out.advised += isAligned || run.components[c].grid->workingCells > 0.0 ? 1 : 0;
    out.isOpen.push_back(isCertified && isAligned ? 0 : 1);
  }
  return out;
}

/// Ids of a split surface mean nothing to its user.
Failure withoutPlaces(Failure failure) {
  failure.where.clear();
  return failure;
}

Note splitNote(const RefinedFacts& facts, const Model& refined, bool crossesPlane, bool isForGrid) {
  Note note(crossesPlane ? "symmetric-split" : "features-split",
            {{"edges", facts.edges},
             {"vertices", refined.source().mesh.positions.size()},
             {"triangles", refined.source().mesh.triangles.size()},
             {"verticesBefore", facts.verticesBefore},
             {"trianglesBefore", facts.trianglesBefore}});
  if (!crossesPlane) note.values.push_back({"grid", isForGrid ? 1 : 0});
  return note;
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

/// Solves on the split surface, with its facts in `run`.
Result<std::shared_ptr<Session::State>> Session::State::solveOn(SplitModel& made,
                                                                const SolveOptions& options,
                                                                RunRecord& run) {
  auto next = std::make_shared<State>();
  if (Status taken = next->take(std::move(made.refined->model)); !taken) return taken.error();
  Status done = next->solveRequest(*made.carried, options, run);
  if (done) done = next->solveWithWorkingCells(options, run);
  if (!done) return isFinal(done) ? done.error() : withoutPlaces(done.error());
  run.refined = std::move(made.facts);
  return next;
}

Status Session::State::solveSplit(const Request& request, const SolveOptions& options,
                                  RunRecord& run) {
  const auto start = std::chrono::steady_clock::now();
  const bool mustSplit = isCrowded(*model, request);
  Status first = Done{};
  Reached best{std::vector<char>(model->components.size(), 1)};
  if (!mustSplit) {
    first = solveRequest(request, options, run);
    if (first) first = solveWithWorkingCells(options, run);
    if (isFinal(first)) return first;
    if (first) best = reachedBy(solved->stored.certificates, run);
    if (best.isWhole()) return first;
  }
  std::size_t rounds = roundsOf(run), last = model->source().mesh.triangles.size();
  std::string tried;
  for (const Splits splits : kAllSplits) {
    SplitModel made(*model, request);
    const Status split = made.split(splits, best.isOpen);
    const std::size_t size = made.model->source().mesh.triangles.size();
    if (!split && first && best.certified < 0) first = split.error();
    const bool isTooLarge = splits != Splits::kCrowded && isTooLargeToSplit(*made.model);
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
    if (!next && first && best.certified < 0) first = next.error();
    if (!next) continue;
    Reached reached = reachedBy((*next)->solved->stored.certificates, again);
    if (!reached.isMoreThan(best, mustSplit)) continue;
    const bool isForGrid = best.hasAllMaps();
    best = std::move(reached);
    again.refined->roundsBefore = before;
    again.notes.push_back(splitNote(*again.refined, *(*next)->model, made.crossesPlane, isForGrid));
    again.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    (*next)->publish(again);
    finer = std::move(*next);
    if (best.isWhole()) break;
  }
  if (!finer && first && !tried.empty())
    run.notes.push_back(Note("features-split-in-vain",
                             {{"grid", best.hasAllMaps() ? 1 : 0}, {"triangles", tried}}));
  HGP_CHECK(finer || !mustSplit || !first, "a surface without splits is left without a map");
  return finer ? Status(Done{}) : first;
}

}  // namespace hgp::api
