// Rotations across the seams, read from a frame field combed over S_c.  Role: r_ij of [BCW17 (12)]
// and r_s of (14); frames of (13) come from the same combing, so both agree by construction.
#pragma once

#include "hgp/cut/cut_mesh.h"
#include "hgp/field/frame_field.h"

namespace hgp {

struct SeamRotations {
  int q = 4;
  /// Across seam halfedge h from face(h) to its twin's: uv edge vectors turn by 2πr/q,
  /// z' = e^{i2πr/q} z + t. In {0, …, q − 1}; r[twin] = −r[h] mod q; 0 off the seam.
  PerHalfedge<int> rotation;
  /// Angle, in face coordinates and radians, of the combed direction that the map sends to the positive real axis.
  PerFace<double> frameAngle;
};

/// @pre field's matchings are trivial around every non-cone vertex
SeamRotations seamRotations(const TriMesh& mesh, const CutMesh& cut, const FrameField& field);

}  // namespace hgp
