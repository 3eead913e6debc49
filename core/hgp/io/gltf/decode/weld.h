// The primitives of one mesh as one surface.  Role: glTF splits vertices wherever an attribute is
// discontinuous; welding by exact position reverses that and records how, so that the map can be written.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/decode/store.h"

namespace hgp::io {

/// Primitives that share their vertices (the same POSITION accessor) and therefore the table of copies.
struct GltfPool {
  std::vector<int> primitives;  ///< ascending
  int vertexCount = 0;
  int firstStored = 0;  ///< stored vertex = firstStored + index into the pool
};

/// Consecutive triangles of the surface that come from one primitive.
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
  /// Per triangle, if repairs are written; otherwise empty. Corners of one stored vertex with different
  /// numbers become different vertices; a triangle with kUnedited at every corner is as it was stored.
  std::vector<std::array<int, 3>> copy;
  static constexpr int kUnedited = -1;
  Surface surface;
};

/// The surface of mesh number `mesh`; it has no runs if the mesh has no triangles. Vertices are welded as
/// EXT_mesh_manifold states, if the mesh has it and it is usable, and by exact position otherwise.
Result<GltfSurface> weldGltfMesh(const GltfStore& store, int mesh, const Limits& limits);

/// Offset of each run's indices in the index array of EXT_mesh_manifold. Empty unless that array consists of
/// exactly the primitives' own indices; otherwise the extension is neither read nor kept.
std::optional<std::vector<std::size_t>> manifoldStarts(const GltfStore& store, int mesh,
                                                       const std::vector<GltfRun>& runs);

/// Triangles of a primitive as stored vertex indices 0 … n − 1. Triangles of strips and fans that repeat an
/// index are skipped; lists are kept whole.
std::vector<std::array<std::uint32_t, 3>> primitiveTriangles(
    int mode, const std::vector<std::uint32_t>& indices);

}  // namespace hgp::io
