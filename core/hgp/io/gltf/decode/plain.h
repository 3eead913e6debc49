// Meshes of a glTF asset as plain surfaces, placed as in its scene.  Role: converts glTF to OBJ.
#pragma once

#include <vector>

#include "hgp/io/gltf/decode/weld.h"
#include "hgp/io/plain_surface.h"

namespace hgp::io {

/// For `surface` −1: every instance of one of `parts` in the scene, in world coordinates, and the parts without
/// an instance in their own. Otherwise that part alone, in its own coordinates.
/// @param surfaces  in the order of `parts`
PlainFile plainGltf(const GltfStore& store, const std::vector<GltfSurface>& parts,
                    const std::vector<Surface>& surfaces, int surface);

}  // namespace hgp::io
