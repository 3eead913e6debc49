// What a map is compared with.  Role: the prescription, checked against the mesh and laid out by vertex.
#pragma once

#include <optional>
#include <vector>

#include "hgp/mesh/holonomy_spec.h"
#include "hgp/verify/angles.h"
#include "hgp/verify/reason.h"
#include "hgp/verify/thresholds.h"

namespace hgp {

/// The prescription in the form that the measurements need, and the reasons why it does not fit the mesh.
struct AskedMap {
  AskedAngles angles;
  std::vector<std::optional<int>> handles;  ///< reduced mod q
  std::vector<EdgeId> features;             ///< those that are edges of the mesh
  std::vector<Reason> mismatches;           ///< of Rule::kPrescription
};

/// @param handleCount  2g, or 0 where handles are not measured
AskedMap layOutAsked(const TriMesh& mesh, const Topology& topology, int handleCount,
                     const HolonomySpec& asked, const CertifyOptions& options);

}  // namespace hgp
