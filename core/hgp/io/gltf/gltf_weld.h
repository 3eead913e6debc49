// The primitives of one mesh as one surface.  Role: glTF splits vertices wherever an attribute
// jumps; welding by exact position undoes it, and remembers how, for the way back.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/gltf_store.h"

namespace hgp::io {

/// Primitives that draw from the same vertices (the same POSITION data). One xref drives them all.
struct GltfPool {
  std::vector<int> primitives;  ///< ascending
  int vertexCount = 0;
  int firstStored = 0;  ///< stored vertex = firstStored + index into the pool
};

/// A run of surface triangles that come from one primitive.
struct GltfRun {
  int primitive = -1;
  int pool = -1;
  int firstTriangle = 0, triangleCount = 0;
};

struct GltfSurface {
  int mesh = -1;  ///< index in the file
  std::vector<GltfPool> pools;
  std::vector<GltfRun> runs;               ///< in the order of the surface's triangles
  std::vector<std::array<int, 3>> stored;  ///< |F| × 3 stored vertices
  std::vector<int> welded;                 ///< stored vertex → vertex of the surface
  bool isWeldedByExtension = false;        ///< EXT_mesh_manifold; otherwise by position
  /// Where repairs are written, per triangle; otherwise empty. Corners of one stored vertex with other
  /// numbers here get vertices of their own; kUnedited everywhere: the triangle is as it is stored.
  std::vector<std::array<int, 3>> copy;
  static constexpr int kUnedited = -1;
  Surface surface;
};

/// The surface of mesh number `mesh`; without triangles it has no runs. EXT_mesh_manifold decides
/// the weld where it is there and holds; exact position otherwise.
Result<GltfSurface> weldGltfMesh(const GltfStore& store, int mesh, const Limits& limits);

/// Where each run's indices begin in the array of EXT_mesh_manifold. Nothing unless that array is made
/// of the primitives' own indices and nothing else: then the extension is neither read nor kept.
std::optional<std::vector<std::size_t>> manifoldStarts(const GltfStore& store, int mesh,
                                                       const std::vector<GltfRun>& runs);

/// Triangles of a primitive as stored vertex indices 0 … n − 1; strips lose the triangles that
/// repeat an index, lists keep everything.
std::vector<std::array<std::uint32_t, 3>> primitiveTriangles(
    int mode, const std::vector<std::uint32_t>& indices);

}  // namespace hgp::io
