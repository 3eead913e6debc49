// Walks along the lines of a grid on the surface.  Role: from one grid point to the next, face by face and across
// seams, for extracting quads and for looking at few of them.
#pragma once

#include <compare>
#include <optional>
#include <vector>

#include "hgp/quads/grid_lines.h"

namespace hgp {

/// A unit edge of the grid at the grid point from which it leaves, in the plane of a face that has it in the half-open
/// range of its directions there (counterclockwise, the first one included).
struct GridRay {
  FaceId face;
  LatticePoint at;
  int direction = 0;  ///< quarter turns from the u axis
  friend bool operator==(const GridRay&, const GridRay&) = default;
};

/// What of a closed face holds one of its points.
struct GridPlace {
  enum class Kind : unsigned char { kVertex, kEdge, kFace };
  Kind kind = Kind::kFace;
  /// The halfedge on which it lies or which leaves it; invalid inside the face.
  HalfedgeId on;
};
/// @pre p lies in the closed face f
GridPlace placeIn(const LatticeMap& map, FaceId f, const LatticePoint& p);

/// The same grid point has the same key, whatever the face it is seen from.
struct GridKey {
  GridPlace::Kind kind = GridPlace::Kind::kFace;
  int element = -1;  ///< vertex, edge or face
  std::int64_t u = 0, v = 0;
  friend auto operator<=>(const GridKey&, const GridKey&) = default;
};
GridKey keyOf(const LatticeMap& map, FaceId f, const LatticePoint& p);

/// The grid directions from `start` (included) to `end` (excluded), counterclockwise; −1 behind the last.
/// @pre `start` and `end` are at most half a turn apart
std::array<int, 2> directionsBetween(const LatticeMap& map, const LatticePoint& start,
                                     const LatticePoint& end);

/// From face f along a grid line to its point q: the face that holds q, q in its plane, and the direction back.
/// The walk is just left of the line, that is, points on the line count as right of it, so that lines through
/// vertices and along edges are not special cases. Nothing where it leaves the surface.
/// @param q  in the plane of f, on a line through f
std::optional<GridRay> walkTo(const LatticeMap& map, FaceId f, LatticePoint q, int direction);

/// The ray of an edge at its end, given the result of walkTo(). It lies strictly inside that face, or on the last ray of
/// the face's corner: then it belongs to the next face. `alongBoundary`: there is none, as the edge runs along the
/// boundary.
struct GridArrival {
  GridRay ray;
  bool alongBoundary = false;
};
GridArrival arrivalOf(const LatticeMap& map, const GridRay& end, const GridPlace& place);

/// All rays at a grid point.
struct GridRing {
  std::vector<GridRay> rays;  ///< counterclockwise; at the boundary from one side to the other
  bool isClosed = true;       ///< not at the boundary
};
GridRing ringAt(const LatticeMap& map, FaceId f, const LatticePoint& p);

}  // namespace hgp
