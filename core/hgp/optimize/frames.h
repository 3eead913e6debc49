// Convexification frames on few triangles.  Role: F_cb and d_j of [BCW17 (13)].
#pragma once

#include <array>
#include <vector>

#include "hgp/cut/seam_rotation.h"

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

/// Similarity and antisimilarity parts of a map linear on a triangle:
///   f_z = Σ_k a_k z_k,  f_z̄ = Σ_k b_k z_k,  with b_k = ½ ∇φ_k as a complex number, a_k its conjugate.
struct LinearParts {
  std::array<Complex, 3> similarity;
  std::array<Complex, 3> antisimilarity;
};
LinearParts linearParts(const Geometry& geometry, FaceId f);

/// Grows a set of faces by those that share a vertex with it, `rings` times.
std::vector<FaceId> growFaces(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings);

}  // namespace hgp
