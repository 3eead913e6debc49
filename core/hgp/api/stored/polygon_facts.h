// The polygons of a file in a stored map.  Role: a certificate is about triangles; this is what it means for the
// polygons that they were cut from.
#pragma once

#include "hgp/api/model/model.h"
#include "hgp/io/polygons.h"
#include "hgp/verify/certificate.h"

namespace hgp::api {

struct PolygonFacts {
  int polygons = 0;  ///< with more than three corners
  int notConvex =
      0;  ///< of those, verified as a whole: a corner of the polygon in the map turns by 0 or less
};

/// Reads the map on the surface's triangles. A polygon that is convex in the map has positive triangles along every
/// diagonal; of others only the triangles along hgp's own are known to be positive.
PolygonFacts measurePolygons(const Model& model, io::PolygonsView polygons,
                             const UvMap& surfaceMap);

/// Makes certificates negative where a polygon consists of verified triangles and of copies of others that are left
/// out, and a copy is folded over in the map: as a whole such a polygon is not mapped.
void denyFoldedPolygons(const Model& model, io::PolygonsView polygons, const UvMap& surfaceMap,
                        std::vector<Certificate>& certificates);

/// Makes certificates negative where polygons are not convex in the map.
void denyNotConvex(const Model& model, io::PolygonsView polygons, const UvMap& surfaceMap,
                   std::vector<Certificate>& certificates);

}  // namespace hgp::api
