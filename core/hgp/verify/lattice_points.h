// Points of a triangular lattice read from stored numbers.  Role: exact seams for q = 3, 6, whose rotations have no
// exact coordinates u, v: what is exact is which point of the lattice a stored number stands for.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hgp/verify/orientation.h"

namespace hgp {

/// The point (a + bω) 2^exponent, ω = e^{i2π/3}.
struct SeamPoint {
  std::int64_t a = 0, b = 0;
  bool operator==(const SeamPoint&) const = default;
};

/// e^{i2π sixths/6} p.
SeamPoint turnedBySixths(int sixths, SeamPoint p);

struct LatticePoints {
  int exponent = 0;
  std::vector<SeamPoint> corner;  ///< by halfedge index, as in CornerUv
};

/// u must be a − b/2 in steps of 2^exponent exactly, and v the multiple of 2^m nearest to b √3/2, where 2^m, the
/// largest power of two that divides every v, is at most a quarter of a step, and |v| at most 2⁵¹ steps: each number
/// stands for one point at most.
/// @return nothing where that is not so for one and the same exponent at every corner
std::optional<LatticePoints> latticePoints(const CornerUv& uv);

}  // namespace hgp
