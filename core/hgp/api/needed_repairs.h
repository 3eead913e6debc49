// Which repairs and welds a surface needs, and notes on them.  Role: every file that a viewer can show should get a map;
// notes say what was changed, with numbers.
#pragma once

#include <string>
#include <vector>

#include "hgp/mesh/defects.h"

namespace hgp::api {

/// The repairs that these defects need.
FixOptions neededRepairs(const std::vector<Defect>& defects);

/// requireUsable's sentence without its advice ("Repair with --fix …").
std::string withoutAdvice(const std::string& message);
/// … with advice that names only repairs that have not been made yet.
std::string withoutGiven(const std::string& message, const FixOptions& done, bool isAutomatic);

/// What joining vertices at equal positions would do.
struct WeldFacts {
  int sharing = 0;           ///< vertices at the position of another one
  int componentsBefore = 0;  ///< sets of triangles connected by vertices
  int componentsAfter = 0;
  bool isSoup = false;  ///< several faces, and every one is a component of its own
};

WeldFacts weldFacts(const MeshData& mesh);

/// Boundaries that run beside each other without being joined.
struct CrackFacts {
  int vertices = 0;    ///< boundary vertices with another, unconnected one close by
  double gap = 0;      ///< the largest of their distances
  int onEdges = 0;     ///< boundary vertices inside a boundary edge of others (T-junctions)
  double edgeGap = 0;  ///< the largest distance of those from their edge
};

/// "Close" is below kCrackRatio of the median boundary edge; positions that are equal are not meant.
/// O(boundary) expected.
CrackFacts crackFacts(const MeshData& mesh);
inline constexpr double kCrackRatio = 0.02;

/// Sentences for users; empty where there is nothing to report.
std::vector<std::string> weldNotes(const WeldFacts& weld, bool isWelded);
std::vector<std::string> crackNotes(const CrackFacts& cracks);

}  // namespace hgp::api
