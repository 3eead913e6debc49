// Repairs as a file stores them: corners in another order, copies of vertices.  Role: what
// --write-repairs asks a document to write; no face comes or goes, no point moves.
#pragma once

#include <array>
#include <vector>

namespace hgp {

struct EditedFace {
  int face;
  std::array<int, 3>
      corner;  ///< new corner k is the corner corner[k] (0 to 2) of the face of before
  std::array<int, 3> vertex;  ///< of the new corners: vertices of before, or copies of them
};

struct FaceEdits {
  std::vector<EditedFace> faces;  ///< ascending by face; the others stay as they are
  std::vector<int> copyOf;   ///< vertex V + i is a copy of vertex copyOf[i], V: vertices before
  std::vector<int> outside;  ///< faces that are no part of the surface, ascending
  int turned = 0;            ///< faces whose corners run the other way
};

}  // namespace hgp
