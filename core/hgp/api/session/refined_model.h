// A model with some of its edges split, and the same prescription for it.  Role: the api's part of --refine;
// parametrize/refinement.h chooses the edges.
#pragma once

#include "hgp/api/json/json_text.h"
#include "hgp/api/model/model.h"
#include "hgp/api/request/request.h"
#include "hgp/field/frame_field.h"
#include "hgp/mesh/refine.h"
#include "hgp/parametrize/refinement.h"

namespace hgp::api {

struct RefinedModel {
  Model model;                      ///< its document is the refined file
  std::vector<VertexPair> parents;  ///< of each new surface vertex, in ids before the split
  RefinedFacts facts;
};

/// A model of the positions and triangles of the surface alone. @param lost  says so
Result<Model> modelOfPolygons(const Model& model, Note lost);

/// Whether the file can store split edges. Finds out by writing it, which takes as long.
bool canRefine(const Model& model);

/// Splits edges. @param places  per component of `model`
Result<RefinedModel> refine(const Model& model, const std::vector<std::vector<SplitPlace>>& places);

/// The same prescription on the refined model: cones, boundary loops and features stay where they were. Prescribed handle
/// rotations belong to generators that depend on the mesh, so they are recomputed as holonomies of a field on the
/// component before refinement that has the prescribed ones: both halves of a split edge inherit its matching, and
/// new edges inside a triangle have matching 0.
/// Fails with kUnsupported if repairs prevent matching the components before and after.
/// @param fields  per component; required where handles are prescribed
Result<Request> carryOver(const Model& before, const Request& request,
                          const std::vector<std::optional<FrameField>>& fields,
                          const RefinedModel& refined);

}  // namespace hgp::api
