// Triangles that rounding has flipped.  Role: part of snap.h.
#pragma once

#include <vector>

#include "hgp/base/wide_integer.h"
#include "hgp/grid/straight_places.h"

namespace hgp {

/// Moves vertices of triangles that are not positive, all copies of a vertex together, by a few steps.
template <class Ring>
class PositiveRepair {
 public:
  /// @param closureOf  vertices with a closure (≥ 0) stay, as their place follows from it
  /// @param straight   vertices on features stay; may be null
  /// @param points     in steps, one per copy
  PositiveRepair(const TriMesh& mesh, const SeamStructureOver<Ring>& seams,
                 const PerVertex<int>& closureOf, const StraightPlaces* straight,
                 std::vector<Ring>& points)
      : mesh_(mesh), seams_(seams), closureOf_(closureOf), straight_(straight), points_(points) {}

  bool isPositive(FaceId f) const { return area(f, VertexId(), {}).sign() > 0; }

  /// @param broken  the triangles to repair; those that stay so are left in it
  /// @return the number of vertices moved
  int run(std::vector<FaceId>& broken);

 private:
  /// Area of f, in half cells of the lattice, with vertex v moved by d (as its first copy sees it).
  WideInteger area(FaceId f, VertexId v, Ring d) const;
  WideInteger smallestArea(VertexId v, Ring d) const;
  bool move(VertexId v, std::int64_t reach);

  const TriMesh& mesh_;
  const SeamStructureOver<Ring>& seams_;
  const PerVertex<int>& closureOf_;
  const StraightPlaces* straight_;
  std::vector<Ring>& points_;
};

}  // namespace hgp
