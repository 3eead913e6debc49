// Rounds a map with straight features so that seams and features hold exactly.  Role: the real unknowns of
// features/real_unknowns.h for a map that is given by its uv; part of snap.h.
#pragma once

#include <optional>
#include <vector>

#include "hgp/features/real_unknowns.h"
#include "hgp/seams/seam_structure.h"

namespace hgp {

class StraightPlaces {
 public:
  /// @param closureOf  per vertex: index of its closure if that has a rotation, −1 where the vertex is free
  /// @param features   edges whose ends have nearly the same u or v
  /// @return nothing where the equations have no exact solution in halves
  static std::optional<StraightPlaces> make(const TriMesh& mesh, const SeamStructure& seams,
                                            const IntegerBasis& basis,
                                            const PerVertex<int>& closureOf, const UvMap& map,
                                            const std::vector<EdgeId>& features);

  /// Per copy, its place in steps: free coordinates of vertices are rounded to steps, of translations to even steps, all
  /// others computed from them in integers. Nothing where a place is not an integer.
  /// @param firstUv      per vertex, uv of its first copy in steps
  /// @param translation  per coordinate of the basis, in steps
  std::optional<std::vector<Gaussian>> round(const std::vector<Complex>& firstUv,
                                             const std::vector<Complex>& translation) const;

  /// Whether rounding must not move the vertex on its own: one of its coordinates is shared.
  bool isTied(VertexId v) const { return isTied_[v] != 0; }

 private:
  StraightPlaces(RealUnknowns unknowns, std::vector<int> vertexOf, PerVertex<char> isTied)
      : unknowns_(std::move(unknowns)),
        vertexOf_(std::move(vertexOf)),
        isTied_(std::move(isTied)) {}

  RealUnknowns unknowns_;
  std::vector<int> vertexOf_;  ///< per complex unknown that is a vertex; translations follow
  PerVertex<char> isTied_;
};

}  // namespace hgp
