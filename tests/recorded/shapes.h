// The surfaces of support/shapes.h with coordinates that every C library computes: multiples of 2⁻²⁰.
#pragma once

#include <cmath>
#include <vector>

#include "support/shapes.h"

namespace hgp::recorded::shapes {

using test::Shape;

/// A sine may differ in its last digit from one processor to the next; what is recorded must not.
inline Shape settled(Shape shape) {
  for (Vec3& p : shape.data.positions)
    for (double& x : p) x = std::ldexp(std::round(std::ldexp(x, 20)), -20);
  return shape;
}

inline Shape octahedron() { return settled(test::octahedron()); }
inline Shape cube(int n = 1) { return settled(test::cube(n)); }
inline Shape icosphere(int n) { return settled(test::icosphere(n)); }
inline Shape torus(int m, int n) { return settled(test::torus(m, n)); }
inline Shape pretzel(int genus, int n = 1) { return settled(test::pretzel(genus, n)); }
inline Shape triangle() { return settled(test::triangle()); }
inline Shape disk(int n) { return settled(test::disk(n)); }
inline Shape annulus(int m, int n) { return settled(test::annulus(m, n)); }
inline Shape cylinder(int m, int n) { return settled(test::cylinder(m, n)); }
inline Shape puncturedTorus(int m, int n) { return settled(test::puncturedTorus(m, n)); }
inline Shape withoutFaces(Shape shape, const std::vector<int>& faces) {
  return test::withoutFaces(std::move(shape), faces);
}
inline Shape jittered(Shape shape, double amount, unsigned seed = 1) {
  return settled(test::jittered(std::move(shape), amount, seed));
}
inline Shape scattered(Shape shape, unsigned seed = 1) {
  return test::scattered(std::move(shape), seed);
}

}  // namespace hgp::recorded::shapes
