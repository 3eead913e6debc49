// Which edges to split where a surface is too coarse for a prescription.  Role: the last resort when no move of
// the strategy gives a map; only on request (--refine), because it changes the mesh.
#pragma once

#include <string>
#include <vector>

#include "hgp/parametrize/parametrization.h"

namespace hgp {

/// One reason to split, and the edges that are split for it (an edge counts where it is first named).
struct SplitPlace {
  std::string
      reason;  ///< "cone rings", "between cones", "thin triangles", "around what is wrong", …
  std::vector<EdgeId> edges;
};

/// How far each attempt goes: every one contains the one before.
inline constexpr int kRefinements = 3;

/// Edges to split for attempt 0 … kRefinements − 1, given a map that is not certified:
///   0  link edges of cones whose triangles would need more than 2 rad each there (that raises their
///      valence; dividing the triangles themselves would not), edges that join two cones or cut off a
///      boundary, the longest edges of thin triangles near what is wrong, and all edges of the triangles
///      that are wrong or constrained against each other
///   1  all edges of the triangles within two rings of these and of the cones
///   2  all edges
/// No attempt gives more than kLargestRefinement triangles: then there are no places.
std::vector<SplitPlace> placesToSplit(const TriMesh& mesh, const Parametrization& failed,
                                      int attempt);
inline constexpr int kLargestRefinement = 80'000;

}  // namespace hgp
