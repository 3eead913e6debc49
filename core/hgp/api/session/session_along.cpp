#include "hgp/api/session/session_state.h"
#include "hgp/parametrize/along/along_features.h"
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

}  // namespace hgp::api
