// Surfaces built in code, with their topology known beforehand.  Role: the families that laws are
// tested on.
#pragma once

#include <string>
#include <vector>

#include "hgp/mesh/tri_mesh.h"

namespace hgp::test {

/// A surface and what is known of it: genus, boundary loops, Euler characteristic 2 − 2g − m.
struct Shape {
  std::string name;
  MeshData data;
  int genus = 0;
  int loops = 0;
  int eulerCharacteristic() const { return 2 - 2 * genus - loops; }
  /// Fails the program when the data is no manifold: a shape is correct by construction.
  TriMesh mesh() const;
};

// Closed surfaces, counterclockwise seen from outside.
Shape tetrahedron();
Shape octahedron();
/// n × n squares per side, each cut along one diagonal; edge length 1 in total.
Shape cube(int n = 1);
/// The icosahedron with every edge cut into n, pushed out to the unit sphere: 20n² faces.
Shape icosphere(int n);
/// m × n quads around and along a torus of revolution (radii 1 and 0.4), m, n ≥ 3.
Shape torus(int m, int n);
/// A bar of (2g + 1) × 3 × 1 unit cubes with g of them taken out: g holes in a row. Squares are cut
/// into n × n, and each into two triangles.
Shape pretzel(int genus, int n = 1);
inline Shape doubleTorus(int n = 1) { return pretzel(2, n); }

// With boundary.
/// One triangle.
Shape triangle();
/// (m + 1) × (n + 1) vertices of the unit square scaled to m × n, flat.
Shape grid(int m, int n);
/// n rings of vertices (6, 12, …) around a centre, flat and round: 6n² triangles.
Shape disk(int n);
/// m around, n between radii 1 and 2, flat.
Shape annulus(int m, int n);
/// The same rolled up, with height n.
Shape cylinder(int m, int n);
/// A torus with one quad taken out.
Shape puncturedTorus(int m, int n);
/// `shape` without one face, for every face listed (they must not share vertices): one loop each.
Shape withoutFaces(Shape shape, const std::vector<int>& faces);
/// Vertices moved by at most `amount` at random (fixed seed), connectivity kept.
Shape jittered(Shape shape, double amount, unsigned seed = 1);
/// Triangles and vertices in random order (fixed seed).
Shape scattered(Shape shape, unsigned seed = 1);

/// Families for laws.
std::vector<Shape> closed();
std::vector<Shape> withBoundary();
std::vector<Shape> all();

/// The mesh of hand-written data; fails the program when it is no manifold.
TriMesh meshOf(const MeshData& data);

}  // namespace hgp::test
