// Repairs as a file stores them: corners in another order, copies of vertices.  Role: what
// --write-repairs asks a document to write; no face is added or removed, and no vertex moves.
#pragma once

#include <array>
#include <vector>

namespace hgp {

struct EditedFace {
  int face;
  std::array<int, 3> corner;  ///< new corner k was corner corner[k] (0 to 2) of the old face
  std::array<int, 3> vertex;  ///< of the new corners: old vertices, or copies of them
};

struct FaceEdits {
  std::vector<EditedFace> faces;  ///< ascending by face; the others are unchanged
  std::vector<int>
      copyOf;  ///< vertex V + i is a copy of vertex copyOf[i]; V: number of old vertices
  std::vector<int> outside;  ///< faces that are not part of the surface, ascending
  int turned = 0;            ///< faces whose corners run the other way
};

}  // namespace hgp
