// Polygons with some of their edges split, or with corners in another order.  Role: what the polygon
// formats need to store a refined or repaired surface; polygons that nothing happens to stay whole.
#pragma once

#include <map>
#include <utility>

#include "hgp/io/polygon/polygon_mesh.h"
#include "hgp/mesh/face_edits.h"
#include "hgp/mesh/refine.h"

namespace hgp::io {

struct RefinedPolygons {
  PolygonMesh polygons;
  std::vector<VertexPair> parents;  ///< of each new vertex; equal for a copy
  std::vector<int> polygonOrigin;   ///< polygon → polygon of before
  std::vector<VertexPair> corners;  ///< corner → two corners of before, its mean; equal for one
  std::vector<char> isSame;         ///< per polygon: as before
};

/// @param corners  the triangulation of `polygons`
RefinedPolygons splitEdges(const PolygonMesh& polygons, const TriangleCorners& corners,
                           const MeshData& triangles, const std::vector<VertexPair>& edges);

/// A polygon whose triangles are all edited alike stays one polygon; others become their triangles.
/// @param corners  the triangulation of `polygons`
RefinedPolygons editFaces(const PolygonMesh& polygons, const TriangleCorners& corners,
                          const FaceEdits& edits);

/// Numbers of interpolated corner values: one per pair of values, behind those that are there.
class MeanValues {
 public:
  explicit MeanValues(int count) : count_(count) {}
  /// −1 where one is missing.
  int of(int a, int b);
  /// The pairs, in the order of their numbers.
  const std::vector<VertexPair>& pairs() const { return pairs_; }

 private:
  int count_;
  std::map<VertexPair, int> found_;
  std::vector<VertexPair> pairs_;
};

}  // namespace hgp::io
