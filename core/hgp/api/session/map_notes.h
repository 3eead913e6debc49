// Notes on a map in addition to its verdict.  Role: what users are told about one component.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/api/model/model.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// Triangles whose area scale (uv area per surface area) is below this fraction of the median are crushed:
/// a texture is stretched about thirtyfold in length there.
inline constexpr double kCrushedScale = 1e-3;

/// Count of crushed triangles and the worst, with ids of the component; nothing if there are none.
/// @param map  of the component's own mesh
std::optional<Note> crushedNote(const ModelComponent& component, const UvMap& map);

/// A note if the number of automatic cones is not the number asked for.
std::optional<Note> countNote(int asked, const CompleteSpec& chosen);

/// What a verified surface has and the mesh of its cones had not, or the other way round: other numbers of triangles and
/// vertices, and boundaries for which the cones give no turning.
Notes mismatchNotes(const Model& model, const prescription::Prescription& cones);

}  // namespace hgp::api
