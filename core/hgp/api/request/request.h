// Resolves the ids, loops, generators and fields of a prescription on a mesh.
// Role: prescription::Prescription → one HolonomySpec per connected component, and back.
#pragma once

#include "hgp/api/model/model.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/reflection.h"

namespace hgp::api {

struct ComponentRequest {
  HolonomySpec spec;
  bool isAutomatic = false;        ///< nothing is prescribed for this component: choose its cones
  std::optional<FieldData> field;  ///< the component's part of the field, in ids of the component
  std::shared_ptr<const Mirror> mirror = {};  ///< in which its map is to be symmetric
  std::optional<Failure> refusal = {};        ///< why it has no map, while others are made
};

struct Request {
  int q = 4;
  std::vector<ComponentRequest> components;
  std::optional<MirrorPlane> plane = {};  ///< across which the map is to be symmetric
  Notes notes;
};

/// Fails with kPrescription for vertices, loops or generators that do not exist, for cones without a vertex at
/// their position, and for fields that contradict the cones that came with them.
/// @pre model.components is not empty
Result<Request> resolve(const Model& model, const prescription::Prescription& prescription);
/// The same without features.
Result<Request> resolveCones(const Model& model, const prescription::Prescription& prescription);

/// A request in which the cones of every component are chosen automatically.
Request automaticRequest(const Model& model, int q);

/// The prescription of all components, in ids of the surface and with the cones' positions.
prescription::Prescription describe(const Model& model, const std::vector<HolonomySpec>& specs);

}  // namespace hgp::api
