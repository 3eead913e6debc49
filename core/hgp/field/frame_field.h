// A rotationally symmetric field with its matchings.  Role: frames and seam rotations are both read from it,
// so that they agree by construction [BCW17 §7 ¶2].
#pragma once

#include "hgp/mesh/field_data.h"
#include "hgp/mesh/geometry.h"
#include "hgp/mesh/topology.h"

namespace hgp {

/// Direction a of face f has angle angle[f] + 2πa/q in the face's coordinates (Geometry). Across
/// halfedge h it continues as direction a + matching[h] of the twin's face.
struct FrameField {
  int q = 4;
  PerFace<double> angle;      ///< radians, any real
  PerHalfedge<int> matching;  ///< any integer; matching[twin] = −matching[h]; 0 on the boundary
};

/// Σ of matchings along a dual loop: its holonomy r, reduced to {0, …, q − 1}.
int loopHolonomy(const FrameField& field, const DualLoop& loop);

/// Principal matching: the nearest direction across each edge, for a field that is given by directions only.
void matchPrincipally(const TriMesh& mesh, const Geometry& geometry, FrameField& field);

/// The angle of cone v in units of 2π/q, when every crossing turns by less than half a step from
/// transport: k = q − (q/2π)(K_v + Σ adjustment), an integer.
/// Valid for interior vertices.
int inducedAngleIndex(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                      VertexId v);

/// The same for a boundary loop: its turning index l.
int inducedTurning(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                   const BoundaryLoop& loop);

/// How far the field is from transport: Σ over interior edges of the squared adjustment, each in
/// (−π, π] radians.
double squaredTurn(const TriMesh& mesh, const Geometry& geometry, const FrameField& field);

}  // namespace hgp
