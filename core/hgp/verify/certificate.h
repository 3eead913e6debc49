// The judge: what a map is, by inspection.  Role: hypotheses and conclusion of [BCW17 Thm 6.1],
// Def. C.1. Shares no code with the method; sees only a mesh, the asked angles and uv.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

// (contract; completed by the verify room)
struct Certificate;

}  // namespace hgp
