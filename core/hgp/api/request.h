// A prescription meets a mesh: ids, loops and generators are found, fields are read.
// Role: io::Prescription → one HolonomySpec per connected component, and back.
#pragma once

#include "hgp/api/model.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp::api {

struct ComponentRequest {
  HolonomySpec spec;
  bool isAutomatic = false;        ///< nothing was asked of this component: choose its cones
  std::optional<FieldData> field;  ///< its part of the field that was read, in its own ids
};

struct Request {
  int q = 4;
  std::vector<ComponentRequest> components;
  std::vector<std::string> notes;
};

/// Fails with kPrescription for vertices, loops or generators that are not there, for cones that have
/// moved away, and for fields that contradict the cones that came with them.
/// @pre model.components is not empty
Result<Request> resolve(const Model& model, const io::Prescription& prescription);

/// Every component automatic.
Request automaticRequest(const Model& model, int q);

/// The prescription of all components in ids of the surface, cones with their positions.
io::Prescription describe(const Model& model, const std::vector<HolonomySpec>& specs);

}  // namespace hgp::api
