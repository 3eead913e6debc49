// Triangles that a frame leaves reversed, solved again with what is around them.  Role: the patches of a run, for a map
// that changes under the hand.
#pragma once

#include <functional>

#include "hgp/parametrize/live/frame_rows.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp::live {

/// The map that is mended, at most kMaxMended triangles of it.
struct Mending {
  const TriMesh& mesh;
  const SeamlessSetup& setup;
  const MovedCut& cut;
  std::function<bool(VertexId)> hasRow;    ///< interior vertices that are no cones
  std::function<int(VertexId)> unknownOf;  ///< −1: determined by others
  std::function<double(VertexId)> scale;   ///< u
  std::function<Complex(FaceId)> target;   ///< f_z of a similarity along the frames
};
inline constexpr std::size_t kMaxMended = 16;

/// Triangles of the map without positive area (in float64, without bounds: the verifier decides).
std::vector<FaceId> reversedFaces(const Mending& on, const Eigen::VectorXcd& x);

/// Moves the vertices within two rings of the reversed triangles, everything else held: the sum of squares of harmonic rows
/// and of changes of triangles (stiffness) that keeps them near where they are, with growing weight on similarity of the
/// reversed ones. Seams are satisfied for any x. The rows there no longer vanish, as on the patches of a run.
/// @return whether no triangle is reversed any more; otherwise x is the best found
bool mend(const Mending& on, Eigen::VectorXcd& x);

}  // namespace hgp::live
