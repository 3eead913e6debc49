#include "hgp/api/request/feature_list.h"
#include "hgp/api/session/guard.h"
#include "hgp/api/session/session_state.h"

namespace hgp::api {

Result<FeatureList> Session::features(const prescription::Prescription& prescription,
                                      const std::string& name) const {
  return guarded([&]() -> Result<FeatureList> {
    if (Status ready = requireComponents(state_->model); !ready) return ready.error();
    const Model& model = *state_->model;
    Result<Request> request = resolve(model, prescription);
    if (!request) return request.error();
    return listFeatures(model, *request, name);
  });
}

}  // namespace hgp::api
