// Features of a prescription on a mesh.  Role: prescription::PrescribedFeatures → HolonomySpec::features, and back.
#pragma once

#include "hgp/api/request/request.h"

namespace hgp::api {

/// Sets spec.features of every component that has features, its boundary edges included. Vertices are found by their
/// positions if the mesh has changed. Fails with kPrescription and the places where an edge is none of the surface.
Status addFeatures(const Model& model, const prescription::Prescription& prescription,
                   Request& request);

/// Makes all boundary edges features of the component, and its cones at boundary vertices corners.
void addRims(const TriMesh& mesh, HolonomySpec& spec);

/// Whether nothing but features is prescribed, so that cones are chosen automatically.
bool isFeaturesOnly(const prescription::Prescription& prescription);

/// Whether the options say more about automatic cones than q; where there are features, a field along them has the cones.
bool choosesCones(const SolveOptions& options);

/// Fails with kUsage for options that do not go with features.
Status checkFeatures(const std::optional<prescription::Prescription>& prescription,
                     const SolveOptions& options);

/// The features of all components as polylines, in ids of the surface and with positions.
prescription::PrescribedFeatures describeFeatures(const Model& model,
                                                  const std::vector<HolonomySpec>& specs);

}  // namespace hgp::api
