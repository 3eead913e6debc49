// What a map should be told with, beside its verdict.  Role: sentences for people about one component.
#pragma once

#include <optional>
#include <string>

#include "hgp/api/model.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

/// Triangles whose area scale (uv area per surface area) is below this share of the median are crushed:
/// a texture is smeared thirtyfold in length there.
inline constexpr double kCrushedScale = 1e-3;

/// Count, share of the surface and place of crushed triangles; nothing where there is none.
/// @param map  of the component's own mesh
std::optional<std::string> crushedNote(const ModelComponent& component, const UvMap& map);

/// Where automatic cones are not as many as were asked.
std::optional<std::string> countNote(int asked, const CompleteSpec& chosen);

}  // namespace hgp::api
