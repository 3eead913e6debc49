// Moves of cones that are solved anew.  Role: the second table of bench/LIVE.md.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/result.h"

namespace hgp::bench {

/// Milliseconds of processor time.
struct EditRow {
  std::string name;
  int triangles = 0;
  double first = 0.0;  ///< the first run, after loading
  std::vector<double> moved,
      again;                    ///< a cone one edge farther, and the same prescription once more
  std::vector<double> dropped;  ///< the map of the drag, stored
  int certified = 0;
};

/// Drops random cones one edge beside where they were, and solves.
Result<EditRow> editsOf(const std::string& file, int moves, unsigned seed);

}  // namespace hgp::bench
