// Lists of features in files.  Role: the features of a request → bytes of the formats that are read.
#pragma once

#include "hgp/api/request/request.h"
#include "hgp/api/results.h"

namespace hgp::api {

/// The features of all components: `.json` as hgp-cones without cones, `.sharp`, `.obj` with vertices and l lines, otherwise
/// rows of two vertices. Each edge is listed once; an edge of a `.sharp` that is no convex one is called concave.
FeatureList listFeatures(const Model& model, const Request& request, const std::string& name);

}  // namespace hgp::api
