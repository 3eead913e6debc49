// Fields as the files of others hold them.  Role: what reading fields, and frames from files, are
// tested on.
#pragma once

#include <cmath>

#include "hgp/field/frame_field.h"

namespace hgp::test {

/// The field as a file would hold it: matchings of interior edges, either sign.
inline FieldData matchingsOf(const TriMesh& mesh, const FrameField& field, int sign) {
  FieldData data;
  data.order = field.q;
  data.hasMatchings = true;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h) || field.matching[h] == 0) continue;
    data.matchings.push_back({TriMesh::face(h).i, TriMesh::face(mesh.twin(h)).i, mesh.tail(h).i,
                              mesh.head(h).i, sign * field.matching[h]});
  }
  return data;
}

/// Each face's direction 0 as a vector in space.
inline std::vector<Vec3> directionsOf(const TriMesh& mesh, const FrameField& field) {
  const auto minus = [](const Vec3& a, const Vec3& b) {
    return Vec3{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  };
  const auto dot = [](const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  };
  const auto scaled = [](const Vec3& a, double s) { return Vec3{a[0] * s, a[1] * s, a[2] * s}; };
  std::vector<Vec3> directions;
  for (FaceId f : mesh.faces()) {
    const auto [a, b, c] = mesh.corners(f);
    Vec3 x = minus(mesh.position(b), mesh.position(a));
    x = scaled(x, 1 / std::sqrt(dot(x, x)));
    Vec3 y = minus(mesh.position(c), mesh.position(a));
    y = minus(y, scaled(x, dot(x, y)));
    y = scaled(y, 1 / std::sqrt(dot(y, y)));
    const double angle = field.angle[f];
    Vec3 d{};
    for (std::size_t i = 0; i < 3; ++i) d[i] = std::cos(angle) * x[i] + std::sin(angle) * y[i];
    directions.push_back(d);
  }
  return directions;
}

/// Directions and matchings.
inline FieldData dataOf(const TriMesh& mesh, const FrameField& field, int sign = 1) {
  FieldData data = matchingsOf(mesh, field, sign);
  data.directions = directionsOf(mesh, field);
  return data;
}

}  // namespace hgp::test
