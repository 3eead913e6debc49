#include "hgp/api/session/session_state.h"
#include "hgp/parametrize/along/along_features.h"
#include "hgp/parametrize/mirror/image_map.h"
#include "hgp/parametrize/mirror/symmetric.h"

namespace hgp::api {

Result<Parametrization> Session::State::solveAlong(std::size_t p, const ComponentRequest& request,
                                                   const ParametrizeOptions& options) {
  Result<Parametrization> run =
      request.mirror
          ? parametrizeSymmetric(model->components[p].mesh, request.mirror, request.spec, options)
          : parametrizeAlongFeatures(surfaceOf(p), request.spec, options);
  dropLarge(p);
  return run ? std::move(run) : toSurfaceIds(*model, model->components[p], run.error());
}

Result<Parametrization> Session::State::solveImage(std::size_t p, const ComponentRequest& request,
                                                   const ComponentMap& first,
                                                   const Parametrization& run) {
  if (!first.whyNone.empty())
    return Failure{
        ErrorCode::kNoMap, "symmetric", "its mirror image has none: " + first.whyNone, {}};
  const ModelComponent& component = model->components[p];
  Result<Parametrization> image =
      imageOfMap({first.map, first.copyOf}, run, model->components[at(request.mirror->of)].mesh,
                 component.mesh, request.mirror, request.spec);
  return image ? std::move(image) : toSurfaceIds(*model, component, image.error());
}

}  // namespace hgp::api
