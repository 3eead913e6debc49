// Lengths, angles and areas of S.  Role: the metric that weights, frames and curvature are computed from.
#pragma once

#include <array>

#include "hgp/base/turns.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// The minimum slack of every triangle inequality after mollification, in units of the mean edge length.
inline constexpr double kMollify = 1e-6;
/// The length that evenedGeometry adds, in units of the mean edge length.
inline constexpr double kEvening = 1.0;

/// Geometry of every triangle in the plane, with corner 0 at 0 and corner 1 on the positive real axis.
/// Lengths are in units of the mean edge length (areas in its square), so that every later constant is scale-free.
struct Geometry {
  double mollified = 0.0;                  ///< ε of computeGeometry, in units of `unit`
  double unit = 1.0;                       ///< mean edge length in the mesh's own unit
  PerHalfedge<double> length;              ///< of the halfedge's edge
  PerHalfedge<double> cornerAngle;         ///< at the halfedge's tail, radians
  PerHalfedge<double> direction;           ///< angle of the halfedge in its face's coordinates
  PerFace<std::array<Complex, 3>> corner;  ///< flat position of each corner
  PerFace<double> area;
  PerVertex<double> angleSum;  ///< Θ_v of the surface itself
};

/// The surface's own metric. Where a face has no area (hasNoArea), lengths are mollified [SC20 §4.5]: the same ε is
/// added to all edges, the smallest with l_ij + l_jk − l_ki ≥ kMollify · (mean length) at every corner. The lengths
/// remain a metric, and connectivity does not change. Otherwise ε = 0, lengths
/// are those of the positions, and heights below `relativeHeight` of the longest edge are raised to it.
Geometry computeGeometry(const TriMesh& mesh, double relativeHeight = 1e-6);

/// The evened metric: lengths (l² + kEvening²)^½, l in units of the mean edge length. It satisfies every
/// triangle inequality that l does; long edges keep about their length, and no triangle is thin. Used where the
/// surface's own triangles are too thin for a map to be found in their conformal structure.
Geometry evenedGeometry(const TriMesh& mesh);

/// A metric per triangle, given up to scale, for example the triangles of a map: lengths of the two halfedges of an
/// edge need not agree. Use angles, directions and transports only; lengths are in units of the longest edge of their
/// triangle.
/// @param length  positive; every triangle satisfies the triangle inequalities
Geometry geometryOfShapes(const TriMesh& mesh, const PerHalfedge<double>& length);

/// Cotangent of the angle opposite h in its triangle; the sine counts as 1e-12 at least.
double oppositeCotangent(const Geometry& geometry, HalfedgeId h);

/// K_v = 2π − Θ_v at interior vertices, π − Θ_v on the boundary, radians.
double curvature(const TriMesh& mesh, const Geometry& geometry, VertexId v);

/// Levi-Civita transport across halfedge h: a direction at angle φ in face(h) continues at φ + ρ in
/// the twin's face, each measured in its own face's coordinates. In (−π, π].
double transport(const TriMesh& mesh, const Geometry& geometry, HalfedgeId h);

}  // namespace hgp
