// Feature edges of shapes built in code.  Role: the families that laws of features are tested on.
#pragma once

#include <cmath>
#include <vector>

#include "hgp/mesh/vectors.h"
#include "support/shapes.h"

namespace hgp::test {

inline Vec3 faceNormal(const TriMesh& mesh, FaceId f) {
  const auto [a, b, c] = mesh.corners(f);
  const Vec3 n = cross(subtract(mesh.position(b), mesh.position(a)),
                       subtract(mesh.position(c), mesh.position(a)));
  return scaled(n, 1.0 / norm(n));
}

/// All boundary edges, and the inner ones with a dihedral angle above `degrees`; ascending.
inline std::vector<EdgeId> creasesOf(const TriMesh& mesh, double degrees = 30.0) {
  std::vector<EdgeId> edges;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h) ||
        dot(faceNormal(mesh, TriMesh::face(h)), faceNormal(mesh, TriMesh::face(mesh.twin(h)))) <
            std::cos(degrees * 3.14159265358979 / 180.0))
      edges.push_back(e);
  }
  return edges;
}

struct CreasedShape {
  std::string name;
  TriMesh mesh;
  std::vector<EdgeId> features;
};

/// Closed and open, smooth with rims, and with creases of which three, four and five meet.
inline std::vector<CreasedShape> creasedShapes() {
  std::vector<CreasedShape> all;
  for (const Shape& shape :
       {cube(4), doubleTorus(2), pretzel(1, 3), disk(6), annulus(24, 4), cylinder(16, 6),
        grid(7, 5), puncturedTorus(18, 12), jittered(cube(5), 0.01),
        withoutFaces(icosphere(4), {0, 100, 211}), withoutFaces(cube(5), {60})}) {
    TriMesh mesh = shape.mesh();
    std::vector<EdgeId> features = creasesOf(mesh);
    all.push_back({shape.name, std::move(mesh), std::move(features)});
  }
  return all;
}

}  // namespace hgp::test
