// Repairs in the form in which a file stores them: reordered corners and copies of vertices.  Role: the changes that
// --write-repairs makes to a document; no face is added or removed, and no vertex moves.
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
  int turned = 0;            ///< number of faces that are reversed
};

}  // namespace hgp
