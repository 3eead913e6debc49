// Triangles that a frame leaves wrong, solved again with what is around them.  Role: the patches of a run, for a map
// that changes under the hand.
#pragma once

#include <functional>

#include "hgp/parametrize/live/frame_rows.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp::live {

/// The map that is mended.
struct Mending {
  const TriMesh& mesh;
  const SeamlessSetup& setup;
  const MovedCut& cut;
  VertexId cone;                           ///< the moved one
  double angle;                            ///< that the map should have around it
  std::function<bool(VertexId)> hasRow;    ///< interior vertices that are no cones
  std::function<int(VertexId)> unknownOf;  ///< −1: determined by others
  std::function<double(VertexId)> scale;   ///< u
  std::function<Complex(FaceId)> target;   ///< f_z of a similarity along the frames
};

/// Triangles of the map without positive area (in float64, without bounds: the verifier decides), ascending; with all
/// around the cone where the angles there do not add up.
std::vector<FaceId> wrongFaces(const Mending& on, const Eigen::VectorXcd& x);
/// Those among the given ones.
/// @param faces  ascending, with all around the cone
std::vector<FaceId> wrongAmong(const Mending& on, const std::vector<FaceId>& faces,
                               const Eigen::VectorXcd& x);

/// Moves the vertices within two to five rings of the wrong triangles, everything else held: the sum of squares of harmonic
/// rows and of changes of triangles (stiffness) that keeps them near where they are, with frame conditions on
/// the wrong ones, and on those that are wrong then. Seams are satisfied for any x. The rows there no longer vanish, as on
/// the patches of a run.
/// @return whether no triangle is wrong any more; otherwise x is the best found
bool mend(const Mending& on, Eigen::VectorXcd& x);

}  // namespace hgp::live
