// Meshes of a glTF asset as plain surfaces, where the nodes of its scene put them.  Role: the way from
// glTF to OBJ.
#pragma once

#include <vector>

#include "hgp/io/gltf/gltf_weld.h"
#include "hgp/io/plain_surface.h"

namespace hgp::io {

/// `surface` −1: every node of the scene that shows one of `parts`, in world coordinates, and meshes that no
/// node shows in their own. Otherwise that part alone, in its own coordinates.
/// @param surfaces of the same order as `parts`
PlainFile plainGltf(const GltfStore& store, const std::vector<GltfSurface>& parts,
                    const std::vector<Surface>& surfaces, int surface);

}  // namespace hgp::io
