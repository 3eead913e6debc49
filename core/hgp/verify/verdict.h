// From facts to reasons.  Role: the verdict by inspection alone: a map is certified when
// nothing here finds a reason against it.
#pragma once

#include <vector>

#include "hgp/verify/certificate.h"

namespace hgp {

/// What was asked, laid out for the measurements, and the reasons why it does not fit the mesh.
struct AskedMap {
  AskedAngles angles;
  std::vector<std::optional<int>> handles;  ///< reduced mod q
  std::vector<Reason> misfits;              ///< of Rule::kPrescription
};

/// @param handleCount  2g, or 0 where handles are not measured
AskedMap layOutAsked(const TriMesh& mesh, const Topology& topology, int handleCount,
                     const HolonomySpec& asked, const CertifyOptions& options);

/// Everything that the measured facts break.
/// @param loops  the dual loops that `facts.seams.handles` were measured along
std::vector<Reason> findReasons(const TriMesh& mesh, const Certificate& facts, const CornerUv& uv,
                                const std::vector<DualLoop>& loops, const CertifyOptions& options);

}  // namespace hgp
