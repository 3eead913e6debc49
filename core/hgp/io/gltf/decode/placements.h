// How the nodes of a glTF use its meshes.  Role: a mesh has one map, whoever shows it; programs say how often and how.
#pragma once

#include "hgp/io/gltf/decode/store.h"
#include "hgp/io/gltf/decode/weld.h"
#include "hgp/io/placements.h"

namespace hgp::io {

/// By surface. Nodes of all scenes count; a skinned mesh is where its first joint is in the bind pose.
std::vector<Placements> placementsOf(const GltfStore& store, const std::vector<GltfSurface>& parts);

}  // namespace hgp::io
