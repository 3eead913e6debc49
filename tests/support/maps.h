// Maps whose certificate is known beforehand.  Role: what the verifier is tested on.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "support/shapes.h"

namespace hgp::test {

/// A map given corner by corner; equal uv at one vertex become one copy.
UvMap mapOfCorners(const TriMesh& mesh, const std::vector<Vec2>& cornerUv);
/// uv = (x, y).
UvMap planarMap(const TriMesh& mesh);
/// Triangles laid down one by one along a breadth-first tree of faces, with their own shapes: the
/// global parametrization of a surface that is flat but for cones. Exact for surfaces of unit cubes.
UvMap developedMap(const TriMesh& mesh, FaceId root = FaceId(0));
/// torus(m, n) onto the rectangle m × n, cut along i = 0 and j = 0.
UvMap flatTorusMap(int m, int n);

/// n triangles around a vertex (number 0) and a map of the fan with total angle `angle`.
struct Fan {
  TriMesh mesh;
  UvMap map;
};
Fan fan(int n, double angle);
/// The same with apex angles of a quarter turn each (exact, no seam when n is a multiple of 4).
Fan quarterFan(int n);

}  // namespace hgp::test
