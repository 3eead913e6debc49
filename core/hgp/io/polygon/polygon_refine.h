// Polygons with some edges split or some corners reordered.  Role: lets the polygon formats store a refined or
// repaired surface; unaffected polygons stay whole.
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
  std::vector<int> polygonOrigin;   ///< polygon → original polygon
  std::vector<VertexPair> corners;  ///< corner → the two original corners of which it is the mean
  std::vector<char> isSame;         ///< per polygon: unchanged
};

/// @param corners  the triangulation of `polygons`
RefinedPolygons splitEdges(const PolygonMesh& polygons, const TriangleCorners& corners,
                           const MeshData& triangles, const std::vector<VertexPair>& edges);

/// A polygon whose triangles are all edited alike stays one polygon; others become their triangles.
/// @param corners  the triangulation of `polygons`
RefinedPolygons editFaces(const PolygonMesh& polygons, const TriangleCorners& corners,
                          const FaceEdits& edits);

/// Assigns indices to interpolated corner values: one per pair of values, after the existing ones.
class MeanValues {
 public:
  explicit MeanValues(int count) : count_(count) {}
  /// The index of the mean of values a and b; −1 if one of them is −1.
  int of(int a, int b);
  /// The pairs, in the order of their indices.
  const std::vector<VertexPair>& pairs() const { return pairs_; }

 private:
  int count_;
  std::map<VertexPair, int> found_;
  std::vector<VertexPair> pairs_;
};

}  // namespace hgp::io
