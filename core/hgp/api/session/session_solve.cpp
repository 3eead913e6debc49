#include <algorithm>
#include <chrono>
#include <cmath>

#include "hgp/api/option_table.h"
#include "hgp/api/request/feature_request.h"
#include "hgp/api/request/grid_retries.h"
#include "hgp/api/request/mirror_request.h"
#include "hgp/api/request/other_cones.h"
#include "hgp/api/request/possible_options.h"
#include "hgp/api/request/rectangles.h"
#include "hgp/api/session/automatic_cells.h"
#include "hgp/api/session/map_notes.h"
#include "hgp/api/session/session_state.h"
#include "hgp/api/stored/convex_polygons.h"
#include "hgp/api/stored/stand_in.h"
#include "hgp/base/check.h"
#include "hgp/grid/grid_measures.h"
#include "hgp/parametrize/stage_clock.h"
#include "hgp/prescription/cones.h"

namespace hgp::api {

namespace {

SuggestOptions suggestOptions(int q, const SolveOptions& options) {
  SuggestOptions suggest;
  suggest.q = q;
  suggest.coneCount = options.coneCount;
  suggest.conesFor = options.conesFor;
  suggest.alignToCurvature = options.alignToCurvature;
  suggest.progress = options.progress;
  return suggest;
}

/// Grid options with the same spacing for every component.
GridOptions sharedGrid(const Model& model, GridOptions grid) {
  if (!grid.isAsked() || grid.spacing > 0) return grid;
  double area = 0;
  for (const ModelComponent& component : model.components) area += surfaceArea(component.mesh);
  return {0.0, std::sqrt(area / grid.cells), grid.mode};
}

/// Refuses cells so small that their number is none that `cells` could be.
Status checkSpacing(const Model& model, const GridOptions& grid) {
  if (!(grid.spacing > 0.0)) return Done{};
  double area = 0.0;
  for (const ModelComponent& component : model.components) area += surfaceArea(component.mesh);
  const double most = rowOfFlag<SolveOptions>("--cells")->high;
  if (area / grid.spacing / grid.spacing <= most) return Done{};
  // A hundredth more than the least, so that the printed length works, too.
  return Failure{ErrorCode::kUsage,
                 "align",
                 formatText("cells with edges of %g would be more than %g on this surface of area "
                            "%g; edges of %.3g or more are possible",
                            grid.spacing, most, area, 1.01 * std::sqrt(area / most)),
                 {}};
}

/// Surfaces of more components are prepared again by every call, as large ones are.
constexpr int kKeptComponents = 100;

/// The steps that may be spent on each other choice of cones, relative to that on the first.
constexpr double kShareOfOtherCones = 0.25;

ParametrizeOptions parametrizeOptions(const SolveOptions& options, double stepShare) {
  ParametrizeOptions out;
  out.maxRounds = options.maxRounds;
  out.method = options.method;
  out.maxStepsPerFace *= stepShare;
  out.grid = options.grid;
  out.improve = options.improve;
  out.progress = options.progress;
  return out;
}

Failure negativeCount(int count) {
  return {ErrorCode::kUsage,
          "cones",
          formatText("the number of automatic cones is 0 (as many as suit) or more, not %d", count),
          {}};
}

Failure noField() {
  return {ErrorCode::kUsage,
          "field",
          "Frames from a file need a field file (.rawfield, .rosy or .ffield).",
          {}};
}

}  // namespace

/// The data that all solves of a component share; kept if it is small compared with the factors of a program.
PreparedSurface& Session::State::surfaceOf(std::size_t p) {
  prepared.resize(model->components.size());
  if (!prepared[p]) prepared[p] = std::make_unique<PreparedSurface>(model->components[p].mesh);
  return *prepared[p];
}

void Session::State::dropLarge(std::size_t p) {
  const bool isOneOfMany = model->components.size() > std::size_t{kKeptComponents};
  const bool isLarge = model->components[p].mesh.faceCount() > PreparedSurface::kKeptFaces;
  if (isOneOfMany || isLarge) prepared[p].reset();
}

Result<CompleteSpec> Session::State::chooseCones(std::size_t p, const SolveOptions& options,
                                                 std::vector<StageTime>* times) {
  if (options.coneCount < 0) return negativeCount(options.coneCount);
  SuggestOptions suggest = suggestOptions(options.q, options);
  const GridOptions grid = sharedGrid(*model, options.grid);
  if (grid.isAsked()) suggest.spacing = roomForGrid(grid.spacing, grid.mode, options.q);
  return suggestCones(surfaceOf(p), suggest, times);
}

namespace {

void add(std::optional<Note> note, Notes& notes) {
  if (note) notes.push_back(std::move(*note));
}

}  // namespace

/// Automatic and prescribed cones are solved in the same way: chosen cones are completed and then prescribed. Where they
/// have no map, or leave a grid no room, others are chosen.
Result<Parametrization> Session::State::solveAutomatic(std::size_t p, SolveOptions choice,
                                                       ParametrizeOptions core) {
  const GridOptions grid = choice.grid;
  std::vector<StageTime> times;
  Notes notes;
  const auto solveWith = [&](const SolveOptions& cones,
                             const GridOptions& on) -> Result<Parametrization> {
    Result<CompleteSpec> chosen = chooseCones(p, cones, &times);
    if (!chosen) return chosen.error();
    notes.clear();
    add(countNote(cones.coneCount, *chosen), notes);
    core.grid = on;
    core.areConesFree = !on.isAsked();  // whose room for the grid was looked at
    return hgp::parametrize(surfaceOf(p), toSpec(*chosen), core);
  };
  Result<Parametrization> run = solveWith(choice, grid);
  if (run && !run->isCertified && grid.isAsked()) {
    choice.grid = {};  // without cones spaced for the grid, since a map matters more than a grid
    run = solveWith(choice, grid);
  }
  const double allSteps = core.maxStepsPerFace;
  const auto solveFor = [&](ConesFor purpose) {
    SolveOptions other = choice;
    other.conesFor = purpose;
    return solveWith(other, grid);
  };
  core.maxStepsPerFace = kShareOfOtherCones * allSteps;
  if (Status done = mapWithOtherCones(choice, solveFor, run, notes); !done) return done.error();
  core.maxStepsPerFace = allSteps;
  const int faces = model->components[p].mesh.faceCount();
  if (!isAnyNumberGood(*model, choice, run))
    if (Status done = withOtherCones(faces, choice, grid, solveWith, run, notes); !done)
      return done.error();
  if (!run) return run;
  addNotes(run->notes, std::move(notes));
  run->times.insert(run->times.begin(), times.begin(), times.end());
  return run;
}

Result<Parametrization> Session::State::solveComponent(std::size_t p,
                                                       const ComponentRequest& request,
                                                       const SolveOptions& options) {
  const ModelComponent& component = model->components[p];
  ParametrizeOptions core = parametrizeOptions(options, stepShare);
  if (options.frames == FrameSource::kFile) {
    core.frames = request.field;
    if (!core.frames) return noField();
  }
  if (options.boundary == BoundaryKind::kConvex) {
    Result<Parametrization> run = parametrizeConvex(component.mesh, core);
    return run ? std::move(run) : toSurfaceIds(*model, component, run.error());
  }
  std::vector<StageTime> times;
  StageClock clock(options.progress, times);
  if (!clock.begin(Stage::kPrepare)) return clock.cancelled();
  surfaceOf(p);
  clock.end();
  if (request.mirror || !request.spec.features.empty()) return solveAlong(p, request, core);
  SolveOptions choice = options;
  choice.q = request.spec.q;
  Result<Parametrization> run = request.isAutomatic
                                    ? solveAutomatic(p, std::move(choice), core)
                                    : hgp::parametrize(surfaceOf(p), request.spec, core);
  dropLarge(p);
  if (!run) return toSurfaceIds(*model, component, run.error());
  if (run->isCertified) add(crushedNote(component, run->map), run->notes);
  run->times.insert(run->times.begin(), times.begin(), times.end());
  return run;
}

namespace {

bool maySkip(const Failure& failure) {
  return failure.code != ErrorCode::kCancelled && failure.code != ErrorCode::kUsage;
}

}  // namespace

/// Says where a map has far more or fewer cells than were asked for.
static void noteCells(const Parametrization& only, RunRecord& run) {
  const GridReport& grid = *only.grid;
  // Those along features cannot be chosen.
  const std::size_t cones = only.spec.features.empty() ? only.spec.cones.size() : 0;
  const double asked = run.options.grid.cells;
  if (std::fabs(cellsToAsked(grid, {asked, 0.0, GridMode::kTile}) - 1.0) <= kNearCells) return;
  run.notes.push_back(Note("grid-cells-far", {{"cells", grid.cells + grid.added},
                                              {"asked", asked},
                                              {"cones", cones},
                                              {"perCone", grid.cellsPerCone}}));
}

/// Whether any cells are as good as others: nothing of the map must lie on integers.
static bool isFreeOfGrid(const Parametrization& run) {
  return run.grid->integers == 0 && run.spec.features.empty();
}

/// The component with cells of the shared size, or of a whole fraction where it is too small for these.
Result<Parametrization> Session::State::solveOnGrid(std::size_t p, const ComponentRequest& request,
                                                    const SolveOptions& shared, RunRecord& run) {
  if (request.refusal) return *request.refusal;
  const bool isCounted = run.options.grid.cells > 0.0 && model->components.size() == 1;
  if (!shared.grid.isAsked()) return solveComponent(p, request, shared);
  if (isCounted) {
    Result<Parametrization> only = solveComponent(p, request, shared);
    const bool isAsked = !run.options.choosesCells;
    if (isAsked && only && only->grid && only->grid->isAligned) noteCells(*only, run);
    return only;
  }
  const double area = surfaceArea(model->components[p].mesh);
  const bool isSmall = area < kFewCells * shared.grid.spacing * shared.grid.spacing;
  SolveOptions own = shared;
  int halvings = 0;
  for (int extra = 0;; ++extra) {
    own.grid = wholeFraction(shared.grid, area, extra, halvings);
    Result<Parametrization> component = solveComponent(p, request, own);
    const bool isOver = !component || !component->grid || component->grid->isAligned || !isSmall ||
                        extra == kMaxFiner;
    if (!isOver) continue;
    const bool isAligned = component && component->grid && component->grid->isAligned;
    if (isAligned && halvings > 0 && own.grid.mode == GridMode::kTile && isFreeOfGrid(*component))
      return solveComponent(p, request, shared);
    if (isAligned && halvings > 0) {
      const NoteValue parts = halvings < 63 ? NoteValue("parts", 1LL << halvings)
                                            : NoteValue("parts", std::ldexp(1.0, halvings));
      run.notes.push_back(Note("grid-smaller-cells", {{"component", p}, parts}));
    }
    return component;
  }
}

Status Session::State::solveRequest(const Request& request, const SolveOptions& options,
                                    RunRecord& run) {
  if (Status possible = checkSpacing(*model, options.grid); !possible) return possible;
  if (Status possible = checkSums(*model, request); !possible && !options.keepsGoing)
    return possible;
  SolveOptions shared = options;
  shared.grid = sharedGrid(*model, options.grid);
  std::vector<ComponentMap> maps;
  maps.reserve(model->components.size());
  run.components.reserve(model->components.size());
  bool areAligned = true, areMirrored = request.plane.has_value();
  for (std::size_t p = 0; p < model->components.size(); ++p) {
    const ComponentRequest& asked = request.components[p];
    const int first = asked.mirror ? asked.mirror->of : -1;
    Result<Parametrization> component =
        first < 0 ? solveOnGrid(p, asked, shared, run)
                  : solveImage(p, asked, maps[at(first)], run.components[at(first)]);
    bool isKept = false;
    std::string whyNone;
    if (!component && options.keepsGoing && maySkip(component.error())) {
      whyNone = component.error().message;
      run.notes.push_back(Note(
          "component-without-map",
          {{"component", p}, {"error", errorName(component.error().code)}, {"message", whyNone}},
          component.error().where));
      component =
          standIn(*model, model->components[p], request.q, options.progress, whyNone, isKept);
    }
    if (!component) return component.error();
    const bool isAligned = component->grid && component->grid->isAligned;
    areAligned = areAligned && isAligned;
    areMirrored = areMirrored && whyNone.empty();
    maps.push_back({std::move(component->map), std::move(component->copyOf), component->spec,
                    std::move(component->certificate), isAligned ? 1.0 : 0.0, isKept, whyNone,
                    component->mirror});
    run.components.push_back(std::move(*component));
  }
  if (areMirrored) run.notes.push_back(mirrorNote(*model, request));
  storeMaps(std::move(maps), request.q, options, areAligned, run);
  return Done{};
}

Status Session::State::solve(const std::optional<prescription::Prescription>& prescription,
                             const SolveOptions& asked) {
  const auto start = std::chrono::steady_clock::now();
  Result<Request> request = prescription ? resolve(*model, *prescription)
                                         : Result<Request>(automaticRequest(*model, asked.q));
  if (!request) return request.error();
  const SolveOptions options = withCells(*request, asked);
  if (Status possible = checkOptions(options, request->q); !possible) return possible.error();
  if (Status possible = checkFeatures(prescription, options); !possible) return possible.error();
  if (Status done = makeRectangles(*model, options, *request); !done) return done;
  if (Status mirrored = addMirror(*model, options, *request); !mirrored) return mirrored.error();
  if (options.frames == FrameSource::kAuto) {
    for (ComponentRequest& component : request->components) component.field.reset();
  }
  RunRecord run;
  run.options = options;
  run.isAutomatic =
      (!prescription || isFeaturesOnly(*prescription)) && options.boundary == BoundaryKind::kFree;
  run.notes = request->notes;
  if (options.frames == FrameSource::kFile) run.notes.push_back(Note("field-frames"));
  const bool hasFeatures =
      request->plane || std::any_of(request->components.begin(), request->components.end(),
                                    [](const auto& c) { return !c.spec.features.empty(); });
  const bool hasCones = prescription && prescription->hasCones;
  if (hasFeatures && !hasCones && choosesCones(options))
    run.notes.push_back(Note("features-own-cones"));
  if (hasFeatures) {
    if (Status done = solveSplit(*request, options, run); !done) return done;
  } else {
    if (Status done = solveRequest(*request, options, run); !done) return done;
    if (Status done = solveWithWorkingCells(options, run); !done) return done;
  }
  const bool mayRepair = options.boundary == BoundaryKind::kFree && !hasFeatures;
  if (mayRepair && !solved->stored.isCertified)
    if (Status done = solveImproved(*request, options, run); !done) return done;
  if (mayRepair && !solved->stored.isCertified) {
    if (options.refines && !canRefine(*model)) return solveAsPolygons(prescription, asked);
    if (Status done = solveRefined(*request, options, run); !done) return done;
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  run.seconds = seconds.count();
  request = Result<Request>(Request());  // not needed any more, and the report is large
  if (!finer) publish(run);
  return Done{};
}

}  // namespace hgp::api
