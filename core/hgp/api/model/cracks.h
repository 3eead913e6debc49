// Cracks and T-junctions between the boundaries of a surface.  Role: they are said, and closed where the user asks for a weld.
#pragma once

#include "hgp/base/note.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::api {

/// Boundaries that run alongside each other without being joined.
struct CrackFacts {
  int vertices = 0;    ///< boundary vertices close to another one that they are not connected to
  double gap = 0;      ///< the largest of their distances
  int onEdges = 0;     ///< boundary vertices inside a boundary edge of others (T-junctions)
  double edgeGap = 0;  ///< the largest distance between such a vertex and its edge
  /// A length by which a weld joins those vertices and spoils no triangle; 0: none is known.
  double weld = 0;
  /// Triangles more that would collapse, repeat others or lie at an edge of more than two after a weld by the gap.
  int spoiled = 0;
  bool isPartial = false;  ///< the search ended at its bound; there may be more
};

inline constexpr double kCrackRatio = 0.02;
/// Where triangles lie all over each other, the number of distances would be quadratic.
inline constexpr long long kMaxCrackTests = 1 << 28;

/// "Close" means closer than kCrackRatio times the median length of boundary edges, but not equal. O(boundary)
/// expected; at most about maxTests distances are measured. The weld is tried on the triangles, O(|F| log |F|).
CrackFacts crackFacts(const MeshData& mesh, long long maxTests = kMaxCrackTests);

/// Empty if there is nothing to report.
Notes crackNotes(const CrackFacts& cracks);

}  // namespace hgp::api
