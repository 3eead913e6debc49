#include <chrono>

#include "hgp/api/session_state.h"
#include "hgp/prescription/cones.h"

namespace hgp::api {

namespace {

SuggestOptions suggestOptions(int q, const SolveOptions& options) {
  SuggestOptions suggest;
  suggest.q = q;
  suggest.coneCount = options.coneCount;
  suggest.alignToCurvature = options.alignToCurvature;
  suggest.progress = options.progress;
  return suggest;
}

Failure noField() {
  return {ErrorCode::kUsage,
          "field",
          "Frames from a file need a field file (.rawfield, .rosy or .ffield).",
          {}};
}

}  // namespace

Result<CompleteSpec> Session::State::completeAutomatically(const ModelComponent& component,
                                                           const SolveOptions& options) const {
  Result<CompleteSpec> spec = suggestCones(component.mesh, suggestOptions(options.q, options));
  if (!spec) return toSurfaceIds(*model, component, spec.error());
  return spec;
}

Result<Parametrization> Session::State::solveComponent(std::size_t p,
                                                       const ComponentRequest& request,
                                                       const SolveOptions& options) const {
  const ModelComponent& component = model->components[p];
  ParametrizeOptions core;
  core.maxRounds = options.maxRounds;
  core.useQuality = options.useQuality;
  core.progress = options.progress;
  if (options.frames == FrameSource::kFile) {
    core.frames = request.field;
    if (!core.frames) return noField();
  }
  if (options.boundary == BoundaryKind::kConvex) {
    Result<Parametrization> run = parametrizeConvex(component.mesh, core);
    return run ? std::move(run) : toSurfaceIds(*model, component, run.error());
  }
  if (request.isAutomatic) {
    Result<Parametrization> run =
        parametrizeAutomatically(component.mesh, suggestOptions(request.spec.q, options), core);
    return run ? std::move(run) : toSurfaceIds(*model, component, run.error());
  }
  Result<Parametrization> run = hgp::parametrize(component.mesh, request.spec, core);
  return run ? std::move(run) : toSurfaceIds(*model, component, run.error());
}

/// The result as the flat arrays that leave the session.
void Session::State::flatten(Solved& result) const {
  const StoredMap& stored = result.stored;
  for (const Vec2& p : stored.map.uv) result.uv.insert(result.uv.end(), p.begin(), p.end());
  for (const auto& t : stored.map.cornerUv) {
    for (int i : t) result.cornerToUv.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::size_t p = 0; p < model->components.size(); ++p) {
    for (const MeasuredSeam& s : stored.certificates[p].seams.seams) {
      const SeamEnds ends = seamEnds(*model, model->components[p], stored.map, s.edge);
      result.seams.push_back({{ends.a[0], ends.a[1]}, {ends.b[0], ends.b[1]}, s.r});
    }
  }
}

Status Session::State::solve(const std::optional<io::Prescription>& prescription,
                             const SolveOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  Result<Request> request = prescription ? resolve(*model, *prescription)
                                         : Result<Request>(automaticRequest(*model, options.q));
  if (!request) return request.error();
  if (options.frames == FrameSource::kAuto) {
    for (ComponentRequest& component : request->components) component.field.reset();
  }
  RunRecord run;
  run.options = options;
  run.isAutomatic = !prescription && options.boundary == BoundaryKind::kFree;
  run.notes = request->notes;
  if (options.frames == FrameSource::kFile)
    run.notes.push_back("the frames are the directions of the field");
  std::vector<ComponentMap> maps;
  std::vector<HolonomySpec> specs;
  bool isCertified = true;
  for (std::size_t p = 0; p < model->components.size(); ++p) {
    Result<Parametrization> component = solveComponent(p, request->components[p], options);
    if (!component) return component.error();
    isCertified = isCertified && component->isCertified;
    maps.push_back({std::move(component->map), std::move(component->copyOf), component->spec,
                    component->certificate});
    specs.push_back(toSpec(component->spec));
    run.components.push_back(std::move(*component));
  }
  Solved result;
  result.stored = storeMap(*model, maps, options.scale, isCertified);
  run.notes.insert(run.notes.end(), result.stored.notes.begin(), result.stored.notes.end());
  result.prescription = describe(*model, specs);
  result.cones = io::writeConesJson(result.prescription);
  result.certificate = certificateText(*model, result.stored.certificates);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  run.seconds = seconds.count();
  result.report =
      reportText(*model, run, result.stored.isCertified, result.certificate, result.cones);
  flatten(result);
  solved = std::move(result);
  return Done{};
}

}  // namespace hgp::api
