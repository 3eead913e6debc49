// A part with sharp edges: the pattern, the pattern along them, and quads.  Role: a figure that the paper does not have.
#pragma once

#include <functional>
#include <vector>

#include "../picture/render.h"

namespace hgp::figures {

using Draw = std::function<picture::Image(const picture::Scene&, const picture::Camera&)>;

/// The three panels; none for a map that is missing.
/// @param isCertified  becomes false where a map is not certified or not on a grid
std::vector<picture::Image> partPanels(bool isSmall, const Draw& draw, bool& isCertified);

}  // namespace hgp::figures
