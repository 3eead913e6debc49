// Stored triangles that a certificate does not cover, and their uv.  Role: every triangle of
// the file is either verified as it is stored or counted here.
#pragma once

#include "hgp/api/stored/polygon_facts.h"

namespace hgp::api {

/// Counts over all triangles of the surface as they are stored.
struct OutsideFacts {
  int stored = 0;         ///< triangles of the surface
  int verified = 0;       ///< triangles that the certificate covers
  int duplicates = 0;     ///< not covered: copies of a verified triangle, the twin
  int differing = 0;      ///< duplicates whose uv differ from the twin's: 0 in what param writes
  int zeroArea = 0;       ///< not covered: no area in 3D (LeftOut::kZeroArea)
  int reversed = 0;       ///< verified with the orientation opposite to the stored one
  int splitVertices = 0;  ///< copies of vertices in the verified surface that are not in the file
  PolygonFacts polygons;  ///< where the triangles are parts of polygons
};
OutsideFacts measureOutside(const Model& model, const UvMap& surfaceMap);

/// Assigns uv to the triangles that are left out: copies get those of their twin, the others those of verified
/// triangles at their vertices, if there are any.
/// @param map  on the surface's triangles; −1 at the corners of triangles that are left out
void fillOutside(const Model& model, UvMap& map);

}  // namespace hgp::api
