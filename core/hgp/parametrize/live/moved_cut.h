// The cut surface after one cone has moved along a path of edges.  Role: extends the cut of a solved map instead of
// making a new one, so that only the corners along the path change.
#pragma once

#include <vector>

#include "hgp/parametrize/live/terms.h"
#include "hgp/system/reduced_unknowns.h"

namespace hgp::live {

/// The cone's vertex is the fixed point ζ of the rotation R around it, and R is 1 for no other vertex. If the cone moves
/// along a path, ζ (as an expression in the unknowns) becomes the position of the path's end, and the path becomes a
/// seam: a corner at z to the left of it is at ζ + R (z − ζ) to the right of it. All other transitions keep their
/// rotations and translations, also where the path crosses or follows a seam: it runs just left of such edges. Rotations
/// along handles therefore follow the path.
///
/// Unknowns are numbered as before. The path's end no longer has one: its number is used for the cone's old vertex, whose
/// position in the face to the left of the path's first edge it is.
class MovedCut {
 public:
  /// @param cone  interior. The references must outlive the object.
  MovedCut(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
           const ReducedUnknowns& unknowns, VertexId cone);

  /// @param path  from the cone over interior vertices that are no cones, none of them twice; empty: to where it was
  void move(std::vector<HalfedgeId> path);

  int q() const { return seams_.q; }
  /// c in {0, …, q − 1}: the rotation from the left of the path to its right, and around the cone. If it is 0, the
  /// cone's vertex has an unknown of its own, and moving changes no corner.
  int turn() const { return turn_; }
  /// The unknown that is used for the cone's old vertex; −1 where nothing has changed.
  int reusedUnknown() const { return reused_; }
  const std::vector<HalfedgeId>& path() const { return path_; }

  /// Position of a corner (of tail(h) in face(h)).
  Terms termsOf(HalfedgeId corner) const;
  /// Its uv vertex: a copy of the cut mesh, or a further one.
  int uvOf(HalfedgeId corner) const;
  /// Seam rotation across h from face(h) to its twin's, in {0, …, q − 1}.
  int turnAcross(HalfedgeId h) const;
  /// Its part that is due to the path: c, −c or 0.
  int pathTurnAcross(HalfedgeId h) const;

  /// A uv vertex whose position or corners have changed.
  struct Copy {
    int uv;
    VertexId vertex;
    Terms position;
    std::vector<HalfedgeId> corners;
  };
  const std::vector<Copy>& copies() const { return moved_; }
  /// Number of uv vertices, those beyond cut.vertexCount() being new.
  int uvCount() const { return uvCount_; }

 private:
  Terms anchored(HalfedgeId corner) const;
  Terms crossed(const Terms& point, HalfedgeId h) const;
  void begin(int uv, VertexId vertex, Terms position);
  void append(HalfedgeId corner);
  void moveStart();
  Terms passVertex(Terms point, HalfedgeId in, HalfedgeId out);
  void placeCone(Terms point, HalfedgeId in);

  const TriMesh& mesh_;
  const CutMesh& cut_;
  const SeamRotations& seams_;
  const ReducedUnknowns& unknowns_;
  int turn_ = 0, reused_ = -1, uvCount_ = 0;
  std::vector<HalfedgeId> path_;
  std::vector<Copy> moved_;
  PerHalfedge<int> movedAt_;  ///< corner → index into moved_, −1
};

}  // namespace hgp::live
