// Replaces single edges of a quad mesh.  Role: separates edges with the same ends where a strip through them would run
// over much of the surface.
#pragma once

#include <optional>

#include "hgp/quads/quads.h"

namespace hgp {

/// A quad mesh with what tells edges with the same ends apart.
struct QuadNet {
  QuadMesh mesh;
  /// Per quad and side (from corner k to corner k + 1): the number of its edge.
  std::vector<std::array<int, 4>> edge;
  std::vector<Vec3> middle, middleNormal;  ///< per edge: its middle on the surface …
  std::vector<FaceId> middleFace;          ///< … and the face that holds it
  std::vector<char> isFeature;             ///< per edge: along a feature, where it stays
};

struct Refilled {
  QuadMesh quads;
  int count = 0;  ///< edges that were replaced
};

/// Replaces edges until no two have the same ends. The two quads at such an edge are a hexagon; three quads around its
/// middle fill it in their place. The middle gets three edges, one of the edge's ends loses one, and the other ends of
/// two of the new edges get one more: of the four such fillings the one that keeps cones and folds no quad is taken.
/// Nothing where none of them is possible.
std::optional<Refilled> refill(QuadNet net);

}  // namespace hgp
