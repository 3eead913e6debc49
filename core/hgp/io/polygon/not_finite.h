// Positions of a text that are not finite.  Role: they may stand where no face uses them.
#pragma once

#include <optional>

#include "hgp/io/polygon/polygon_mesh.h"
#include "hgp/mesh/finite.h"

namespace hgp::io {

/// A vertex without a finite position, and the line or byte at which it stands.
struct NotFiniteVertex {
  int vertex = 0;
  std::int64_t place = 0;
};

/// The first of them that a face uses; where there are no faces the first of all.
std::optional<NotFiniteVertex> firstUsed(const std::vector<NotFiniteVertex>& vertices,
                                         const PolygonMesh& polygons);

/// "line 12: vertex 7 has no finite position, and a face uses it", vertices counted from 0.
Failure notFiniteFailure(std::int64_t line, int vertex);

}  // namespace hgp::io
