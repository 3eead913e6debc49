// Lengths, angles and areas of S.  Role: the metric that weights, frames and curvature come from.
#pragma once

#include <array>

#include "hgp/base/turns.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

inline constexpr double kMollify = 1e-6;
/// What evenedGeometry adds, in units of the mean edge length.
inline constexpr double kEvening = 1.0;

/// Geometry of every triangle laid flat with corner 0 at 0 and corner 1 on the positive real axis.
/// Lengths are in units of the mean edge length, so that every later constant is scale-free.
struct Geometry {
  double mollified = 0.0;                  ///< ε above, in units of `unit`
  double unit = 1.0;                       ///< mean edge length in the mesh's own unit
  PerHalfedge<double> length;              ///< of the halfedge's edge
  PerHalfedge<double> cornerAngle;         ///< at the halfedge's tail, radians
  PerHalfedge<double> direction;           ///< angle of the halfedge in its face's coordinates
  PerFace<std::array<Complex, 3>> corner;  ///< flat position of each corner
  PerFace<double> area;
  PerVertex<double> angleSum;  ///< Θ_v of the surface itself
};

/// Where a face has no area (hasNoArea), lengths are mollified [SC20 §4.5]: the same ε is added to all
/// edges, the least with which l_ij + l_jk − l_ki ≥ kMollify · (mean length) at every corner. The metric
/// stays one, and no connection changes. Otherwise ε = 0, lengths
/// are those of the positions, and heights below `relativeHeight` of the longest edge are raised to it.
Geometry computeGeometry(const TriMesh& mesh, double relativeHeight = 1e-6);

/// Of the metric with lengths (l² + kEvening²)^½, l in units of the mean edge length, which satisfies every
/// triangle inequality that l does: long edges stay about as long, and no triangle is thin. A discrete conformal
/// structure that maps can be found in where the surface's own has triangles too thin for that.
Geometry evenedGeometry(const TriMesh& mesh);

/// Of triangles that are each given up to scale, as those of another map or with other angles are: lengths of
/// `length` within a triangle, per halfedge, need not agree across edges. Angles, directions and transports are what it is
/// for. Edges are given in units of the longest of their triangle.
/// @param length  positive; in every triangle the triangle inequalities hold
Geometry geometryOfShapes(const TriMesh& mesh, const PerHalfedge<double>& length);

/// 2π − Θ_v inside, π − Θ_v on the boundary.
double curvature(const TriMesh& mesh, const Geometry& geometry, VertexId v);

/// Levi-Civita transport across halfedge h: a direction at angle φ in face(h) continues at φ + ρ in
/// the twin's face, each measured in its own face's coordinates. In (−π, π].
double transport(const TriMesh& mesh, const Geometry& geometry, HalfedgeId h);

}  // namespace hgp
