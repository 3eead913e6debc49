// Reflections in a plane that map a surface onto itself.  Role: one side of the plane is solved, and the other is its image.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/mesh/box.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// {p : normal · p = offset}, |normal| = 1.
struct MirrorPlane {
  std::string name;  ///< "X", "Y" or "Z" where that is the normal, otherwise ""
  Vec3 normal{1.0, 0.0, 0.0};
  double offset = 0.0;
};
/// The mirrored point.
Vec3 mirrored(const MirrorPlane& plane, const Vec3& p);

/// Planes in which a surface could be symmetric: across X, Y and Z through the centre of the triangles' bounding box; across the
/// principal axes of their corners through their mean, where these are others. An offset below 1e-6 of the box's diagonal is a
/// rounding error of single precision, and 0; so is a coordinate of a normal below 1e-9.
std::vector<MirrorPlane> likelyPlanes(const MeshData& mesh);

/// Vertices may be off their mirrored places by this fraction of the diagonal of their component's bounding box. Which vertex is
/// whose image does not depend on it: that follows from the triangles.
inline constexpr double kMirrorTolerance = 1e-4;
/// The bounding box of a mesh without its unused vertices.
Box<3> boxOfCorners(const TriMesh& mesh);

/// A bijection of the triangles, vertices and edges of `from` and `to` that turns every triangle over.
struct Reflection {
  PerVertex<VertexId> vertex;
  PerHalfedge<HalfedgeId> halfedge;  ///< that of a → b runs from the image of b to that of a
  double distance = 0.0;  ///< between the mirrored place of a vertex and its image, at most
};

/// Finds the reflection by walking over both surfaces at once from a triangle and its image, O(|F|) for each of at most
/// kMaxStarts triangles at the mirrored place of the largest one, the nearest first.
/// @param tolerance  in units of the surface; @pre both connected
inline constexpr std::size_t kMaxStarts = 16;
std::optional<Reflection> findReflection(const TriMesh& from, const TriMesh& to,
                                         const MirrorPlane& plane, double tolerance);

/// The triangles of a surface that have a mirror image: one of its triangles with a corner within the tolerance of the mirrored
/// place of each corner, the other way round. All of them may have one where there is no reflection: images need not be
/// joined as the triangles are.
struct MirrorImages {
  int count = 0;
  FaceId without;  ///< the first that has none
};
/// O(|F| (log |F| + m)), m triangles being within the tolerance of a plane across; for messages only.
MirrorImages mirrorImages(const TriMesh& mesh, const MirrorPlane& plane, double tolerance);

/// A surface's reflection onto itself, or that of another component onto it.
struct Mirror {
  MirrorPlane plane;
  Reflection image;
  int of = -1;  ///< the component whose image this one is; −1: itself
};

/// Whether the reflection exchanges two sides of a connected surface: it is its own inverse, and without what it leaves in place
/// the surface falls into two pieces. Others, of which maps cannot be made of one side, fix no point at all, or curves that
/// cut nothing off, as the exchange of a torus's two angles does.
bool hasTwoSides(const TriMesh& mesh, const Reflection& own);

/// Edges of a surface that the plane contains: every vertex of them is its own image. Ascending.
/// @param own  of the surface onto itself
std::vector<EdgeId> edgesInPlane(const TriMesh& mesh, const Reflection& own);
/// Edges whose ends are images of each other, so that they cross the plane. Ascending.
std::vector<EdgeId> edgesAcross(const TriMesh& mesh, const Reflection& own);

/// The part of a surface on one side of a plane.
struct HalfSurface {
  TriMesh mesh;
  std::vector<VertexId> vertexOrigin;  ///< vertex → vertex of the whole
  std::vector<FaceId> faceOrigin;      ///< corners are in the same order

  HalfedgeId origin(HalfedgeId h) const {
    return TriMesh::halfedge(faceOrigin[at(TriMesh::face(h).i)], h.i % 3);
  }
};

/// The side to which the normal points; its boundary edges are those in the plane and the whole's own.
/// @pre hasTwoSides(); no edge is across
HalfSurface halfOf(const TriMesh& mesh, const Reflection& own, const MirrorPlane& plane);

}  // namespace hgp
