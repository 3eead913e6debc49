// Convexification frames on few triangles.  Role: F_cb and d_j of [BCW17 (13)].
#pragma once

#include <vector>

#include "hgp/cut/seam_rotation.h"
#include "hgp/mesh/face_rings.h"
#include "hgp/system/face_rows.h"

namespace hgp {

/// The constrained triangles with one frame direction each: the map must preserve orientation and send the direction
/// at `angle` (face coordinates) to within a quarter turn of the positive real axis.
struct Frames {
  std::vector<FaceId> faces;   ///< ascending
  std::vector<double> angles;  ///< radians; d_j = e^{−i angle}
};

/// F_cb: triangles with a cone or a boundary vertex. A surface without either (a flat torus) has face 0, whose
/// frame then fixes scale and direction of the map.
std::vector<FaceId> coneAndBoundaryFaces(const TriMesh& mesh, const std::vector<VertexId>& cones);

/// Frames of the given faces from the combed field.
Frames fieldFrames(const SeamRotations& seams, std::vector<FaceId> faces);

/// The frame of each triangle that a map turns into the positive real axis. @param z  per copy
PerFace<double> framesOfMap(const Geometry& geometry, const CutMesh& cut,
                            const std::vector<Complex>& z);

}  // namespace hgp
