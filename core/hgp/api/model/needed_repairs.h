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

/// Empty if there is nothing to report.
Notes weldNotes(const WeldFacts& weld, bool isWelded);

}  // namespace hgp::api
