// A rotationally symmetric direction field as plain arrays.  Role: what io reads from field files;
// field/ gives it meaning.
#pragma once

#include <vector>

#include "hgp/mesh/mesh_data.h"

namespace hgp {

/// How the direction with index a in face `from` continues as index a + turn (mod q) in face `to`.
struct Matching {
  int from = -1;  ///< face whose counterclockwise boundary contains tail → head
  int to = -1;    ///< face on the other side
  int tail = -1;  ///< vertex ids of the shared edge
  int head = -1;
  int turn = 0;  ///< r, any integer; only its class mod q counts
};

/// One direction per face and, where the file stores them, the matchings (which then take precedence).
struct FieldData {
  int order = 4;                    ///< q, directions per face
  std::vector<Vec3> directions;     ///< |F| × 3, one representative each; may be empty
  std::vector<Matching> matchings;  ///< listed edges; others have turn 0 when isComplete
  bool hasMatchings = false;        ///< matchings were stored (edges not listed have turn 0)
};

}  // namespace hgp
