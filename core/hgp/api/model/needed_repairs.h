// Which repairs and welds a surface needs, and notes on them.  Role: hgp should map every file that a viewer can
// show; notes say what was changed, with numbers.
#pragma once

#include <string>
#include <vector>

#include "hgp/mesh/defects.h"

namespace hgp::api {

/// The repairs that these defects need.
FixOptions neededRepairs(const std::vector<Defect>& defects);

/// The advice of requireUsable after these repairs were made: names only those that have not been made yet.
Notes adviceAfter(const Notes& advice, const FixOptions& done, bool isAutomatic);

/// The effect that joining vertices at equal positions would have.
struct WeldFacts {
  int sharing = 0;           ///< vertices at the same position as another one
  int componentsBefore = 0;  ///< sets of triangles connected by vertices
  int componentsAfter = 0;
  bool isSoup = false;  ///< several faces, none of which shares a vertex with another
};

WeldFacts weldFacts(const MeshData& mesh);

/// Boundaries that run alongside each other without being joined.
struct CrackFacts {
  int vertices = 0;    ///< boundary vertices close to another one that they are not connected to
  double gap = 0;      ///< the largest of their distances
  int onEdges = 0;     ///< boundary vertices inside a boundary edge of others (T-junctions)
  double edgeGap = 0;  ///< the largest distance between such a vertex and its edge
  bool isPartial = false;  ///< the search ended at its bound; there may be more
};

inline constexpr double kCrackRatio = 0.02;
/// Where triangles lie all over each other, the number of distances would be quadratic.
inline constexpr long long kMaxCrackTests = 1 << 28;

/// "Close" means closer than kCrackRatio times the median length of boundary edges, but not equal. O(boundary)
/// expected; at most about maxTests distances are measured.
CrackFacts crackFacts(const MeshData& mesh, long long maxTests = kMaxCrackTests);

/// Empty if there is nothing to report.
Notes weldNotes(const WeldFacts& weld, bool isWelded);
Notes crackNotes(const CrackFacts& cracks);

}  // namespace hgp::api
