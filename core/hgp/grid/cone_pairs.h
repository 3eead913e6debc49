// Cones that are neighbours in the map.  Role: neighbours must not be rounded onto one point, because no locally
// injective map has that.
#pragma once

#include "hgp/grid/strain_form.h"

namespace hgp {

/// A path from one cone to another, developed in the plane of the first: D = Σ factor · unknown.
struct ConePair {
  VertexId a, b;
  std::vector<SeamlessChange::Term>
      way;           ///< over chains and, for cones that do not rotate, vertices
  Complex distance;  ///< D of the map itself
};

/// Three cones whose regions of nearest vertices meet in a face: a triangle of the dual of those regions.
struct ConeTriangle {
  ConePair ab, ac;  ///< both laid out in one plane at a; counterclockwise from b to c
};

struct ConeNeighbours {
  std::vector<ConePair> pairs;
  std::vector<ConeTriangle> triangles;
};

/// Pairs whose regions of nearest vertices touch and that are at most `reach` apart along edges; one pair per
/// homotopy class of paths, for example on both sides of a handle.
ConeNeighbours neighbouringCones(const TriMesh& mesh, const SeamStructure& seams,
                                 const SeamlessChange& change, const std::vector<Vec2>& uv,
                                 const std::vector<VertexId>& cones, double reach);

}  // namespace hgp
