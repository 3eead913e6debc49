#include "hgp/api/request/feature_request.h"
#include "hgp/api/request/request.h"

namespace hgp::api {

Result<Request> resolve(const Model& model, const prescription::Prescription& prescription) {
  Result<Request> request = resolveCones(model, prescription);
  if (!request) return request;
  if (Status done = addFeatures(model, prescription, *request); !done) return done.error();
  return request;
}

}  // namespace hgp::api
