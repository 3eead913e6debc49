// A mesh of a glTF with other triangles.  Role: quads and split triangles keep everything else of the file: nodes, skins, morph
// targets, materials, animations, other meshes.
#pragma once

#include "hgp/io/blend.h"
#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/weld.h"

namespace hgp::io {

/// The vertices and triangles that a mesh gets. All of its primitives then share their vertices.
struct GltfRemesh {
  std::vector<Blend> vertices;  ///< means of stored vertices, each of one pool
  std::vector<Vec3> positions;  ///< of all vertices; empty: means like other attributes
  std::vector<std::vector<std::uint32_t>> triangles;  ///< by run, three vertices each
};

/// Primitives without triangles, EXT_mesh_manifold and cones stored in the mesh are left out. Fails with kUnsupported where
/// primitives that share vertices differ in an attribute, or an attribute has different sizes.
Result<Written> remeshGltf(const GltfStore& store, const GltfSurface& part, const GltfRemesh& mesh,
                           const WriteOptions& options);

/// The surface with edges split: the stored vertices, then midpoints in the order of splitEdges().
GltfRemesh splitGltfEdges(const GltfSurface& part, const MeshData& welded,
                          const std::vector<std::array<int, 2>>& edges);

}  // namespace hgp::io
