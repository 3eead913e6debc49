// Positions of a text file that are not finite.  Role: they are accepted at vertices that no face uses.
#pragma once

#include <optional>

#include "hgp/io/polygon/polygon_mesh.h"
#include "hgp/mesh/finite.h"

namespace hgp::io {

/// A vertex without a finite position, and its line or, in an OBJ file, its first byte.
struct NotFiniteVertex {
  int vertex = 0;
  std::int64_t where = 0;
};

/// The first of these vertices that a face uses; without faces, the first one.
std::optional<NotFiniteVertex> firstUsed(const std::vector<NotFiniteVertex>& vertices,
                                         const PolygonMesh& polygons);

/// "line 12: vertex 7 has no finite position, and a face uses it", vertices counted from 0.
Failure notFiniteFailure(std::int64_t line, int vertex);

}  // namespace hgp::io
