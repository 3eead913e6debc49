// Affine maps of glTF nodes.  Role: where nodes put their meshes.
#pragma once

#include <array>

#include "hgp/io/gltf/json/json.h"
#include "hgp/mesh/vectors.h"

namespace hgp::io {

/// An affine map stored by columns, as in glTF: x ↦ m[0] x₀ + m[1] x₁ + m[2] x₂ + m[3].
using Affine = std::array<Vec3, 4>;
inline constexpr Affine kIdentityPlace = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

inline Vec3 applied(const Affine& m, const Vec3& x) {
  Vec3 out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[0][i] * x[0] + m[1][i] * x[1] + m[2][i] * x[2];
  return out;
}
inline Vec3 placed(const Affine& m, const Vec3& x) { return add(applied(m, x), m[3]); }
inline Affine product(const Affine& a, const Affine& b) {
  return {applied(a, b[0]), applied(a, b[1]), applied(a, b[2]), placed(a, b[3])};
}
inline double determinant(const Affine& m) { return dot(m[0], cross(m[1], m[2])); }

/// `matrix`, or the product of `translation`, `rotation` and `scale`, of a node.
Affine localPlace(const JsonText& json, int node);

}  // namespace hgp::io
