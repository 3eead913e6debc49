// A model with some of its edges split, and a request carried over to it.  Role: the api's half of --refine;
// which edges is decided in parametrize/refinement.h.
#pragma once

#include "hgp/api/json_text.h"
#include "hgp/api/model.h"
#include "hgp/api/request.h"
#include "hgp/field/frame_field.h"
#include "hgp/mesh/refine.h"
#include "hgp/parametrize/refinement.h"

namespace hgp::api {

struct RefinedModel {
  Model model;                      ///< its document is the refined file
  std::vector<VertexPair> parents;  ///< of each new surface vertex, in ids of before
  RefinedFacts facts;
};

/// Positions and triangles of the surface alone, which are written as OBJ.
Result<Model> modelOfPolygons(const Model& model);

/// @param places  per component of `model`
Result<RefinedModel> refine(const Model& model, const std::vector<std::vector<SplitPlace>>& places);

/// The same prescription: cones and boundary loops where they were. Given handle rotations are of
/// generators that depend on the mesh, so they are found anew as holonomies of `field`, a field on the
/// component before that has them: its matchings cross the halves of an edge like the edge, and new edges
/// inside a triangle with 0.
/// @param fields  per component; needed where handles are given
/// Fails with kUnsupported where repairs make the components hard to tell apart.
Result<Request> carryOver(const Model& before, const Request& request,
                          const std::vector<std::optional<FrameField>>& fields,
                          const RefinedModel& refined);

}  // namespace hgp::api
