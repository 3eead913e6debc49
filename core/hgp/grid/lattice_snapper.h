// Rounds a map to points of a lattice so that its seams hold exactly.  Role: snap.h for one ring.
#pragma once

#include <optional>
#include <vector>

#include "hgp/grid/stored_numbers.h"
#include "hgp/grid/straight_places.h"

namespace hgp {

struct SnappedMap {
  std::vector<Vec2> uv;
  std::vector<FaceId> notPositive;  ///< triangles that are not positive after all repairs
  int moved = 0;                    ///< vertices that were moved to keep triangles positive
};

/// The smallest e for which all multiples of 2^e up to the size of these uv are exact in the stored type, and so are
/// their 1 − v if those are stored.
int gridExponent(const std::vector<Vec2>& uv, const StoredNumbers& numbers);

template <class Ring>
class LatticeSnapper {
 public:
  /// As SeamSnapper::make; features only over Z[i].
  static std::optional<LatticeSnapper> make(const TriMesh& mesh, const UvMap& map, int q,
                                            const std::vector<VertexId>& cones,
                                            const std::vector<EdgeId>& features);
  /// As SeamSnapper::snap.
  std::optional<SnappedMap> snap(const std::vector<Vec2>& uv, int exponent,
                                 const StoredNumbers& numbers) const;

 private:
  LatticeSnapper(const TriMesh& mesh, SeamStructureOver<Ring> seams, LatticeBasis<Ring> basis);
  std::vector<Ring> round(const std::vector<Vec2>& uv, int exponent, bool isInteger) const;
  std::optional<std::vector<Ring>> rounded(const std::vector<Vec2>& uv, int exponent,
                                           bool isInteger) const;

  const TriMesh* mesh_;
  SeamStructureOver<Ring> seams_;
  LatticeBasis<Ring> basis_;
  PerVertex<int> closureOf_;                ///< −1 where a vertex is free
  std::optional<StraightPlaces> straight_;  ///< where there are features
};

}  // namespace hgp
