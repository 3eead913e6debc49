// From measured facts to the reasons against a map.  Role: the verdict: a map is certified when there is no
// reason against it.
#pragma once

#include <vector>

#include "hgp/verify/certificate.h"

namespace hgp {

/// All rules that the measured facts break.
/// @param loops  the dual loops that `facts.seams.handles` were measured along
std::vector<Reason> findReasons(const TriMesh& mesh, const Certificate& facts, const CornerUv& uv,
                                const std::vector<DualLoop>& loops, const CertifyOptions& options);

}  // namespace hgp
