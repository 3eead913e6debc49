// Arithmetic on Vec3.  Role: one implementation, so that all modules round alike.
#pragma once

#include "hgp/base/portable_math.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

inline Vec3 subtract(const Vec3& a, const Vec3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vec3 add(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec3 scaled(const Vec3& a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
inline double dot(const Vec3& a, const Vec3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double norm(const Vec3& a) { return portable::hypot(a[0], a[1], a[2]); }
inline double distance(const Vec3& a, const Vec3& b) { return norm(subtract(a, b)); }
inline double triangleArea(const Vec3& a, const Vec3& b, const Vec3& c) {
  return 0.5 * norm(cross(subtract(b, a), subtract(c, a)));
}

}  // namespace hgp
