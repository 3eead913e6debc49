// The points of the unit grid on a surface.  Role: the vertices of the quads, found before edges connect them.
#pragma once

#include <utility>
#include <vector>

#include "hgp/quads/grid_walk.h"
#include "hgp/quads/quad_mesh.h"

namespace hgp {

/// Every grid point of an aligned map once, however many triangles meet there.
class GridPoints {
 public:
  struct Point {
    LatticePoint at;  ///< on an edge e: in the plane of mesh.halfedge(e)'s face
    int node;         ///< a vertex of the quad mesh
  };

  /// Finds all points and appends a vertex of `out` for each. The references must outlive the object.
  GridPoints(const LatticeMap& lattice, QuadMesh& out);

  int atVertex(VertexId v) const { return vertexNode_[v]; }  ///< −1 if it is no grid point
  const std::vector<Point>& inside(EdgeId e) const { return edgePoints_[e]; }
  const std::vector<Point>& inside(FaceId f) const { return facePoints_[f]; }
  /// The node at p, which lies at `place` in face f; −1 if there is none.
  int nodeIn(FaceId f, const LatticePoint& p, const GridPlace& place) const;

 private:
  /// Area-weighted normals of the surface's vertices.
  void findNormals();
  void addVertices();
  void addInside(FaceId f);
  /// The range of whole v in which the line u meets face f, and at most one more at either end: a long triangle has few
  /// of the grid points of its box. Rounding here is far below a cell, and addPoint() decides.
  std::pair<std::int64_t, std::int64_t> rowsOf(FaceId f, std::int64_t u) const;
  void addPoint(FaceId f, const LatticePoint& p);
  /// The point p of face f in space.
  int addNode(FaceId f, const LatticePoint& p);
  int addNode(FaceId f, const LatticePoint& p, const Vec3& position, const Vec3& normal);

  const LatticeMap& lattice_;
  const TriMesh& mesh_;
  QuadMesh& out_;
  std::vector<Vec3> normal_;
  PerVertex<int> vertexNode_;
  PerEdge<std::vector<Point>> edgePoints_;
  PerFace<std::vector<Point>> facePoints_;
};

}  // namespace hgp
