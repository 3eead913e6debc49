// Rounds a map to a dyadic grid so that its seams hold exactly.  Role: (12) of [BCW17] in the stored numbers:
// both sides of every seam satisfy z' = i^r z + t without any rounding.
#pragma once

#include <optional>
#include <vector>

#include "hgp/grid/straight_places.h"

namespace hgp {

/// What a stored number type can hold exactly.
struct StoredNumbers {
  int digits = 53;                      ///< of the significand: 53 for float64, 24 for float32
  bool holdsFlipped = false;            ///< 1 − v is stored (glTF): it must be exact, too
  bool hasIntegerTranslations = false;  ///< translations are rounded to integers, not to even steps
};

/// The smallest e for which all multiples of 2^e up to the size of these uv are exact in the stored type, and so are
/// their 1 − v if those are stored.
int gridExponent(const std::vector<Vec2>& uv, const StoredNumbers& numbers);

struct SnappedMap {
  std::vector<Vec2> uv;
  std::vector<FaceId> notPositive;  ///< triangles that are not positive after all repairs
  int moved = 0;                    ///< vertices that were moved to keep triangles positive
};

/// Rounds maps of one surface with the same seams: as solved, moved or scaled.
class SeamSnapper {
 public:
  /// @param map    positive and seamless up to rounding; @param q  1, 2 or 4
  /// @param cones  vertices with a prescribed cone angle
  /// @param features  edges whose ends get equal u or equal v, whichever is closer to being equal
  /// @return nothing where q does not allow it or copies do not follow seams (see readSeams)
  static std::optional<SeamSnapper> make(const TriMesh& mesh, const UvMap& map, int q,
                                         const std::vector<VertexId>& cones,
                                         const std::vector<EdgeId>& features = {});

  /// Rounds vertices to multiples of 2^exponent and translations to multiples of twice that (integers are kept);
  /// computes copies and cones z = T/(1 − i^r) from them in integers. A triangle that this flips
  /// is repaired by moving all copies of one of its vertices together, by a few steps; not of vertices on features.
  /// @param uv  uv of the map, possibly moved or scaled; finite
  /// @return nothing where a number is not exact at this exponent: try the next one
  std::optional<SnappedMap> snap(const std::vector<Vec2>& uv, int exponent,
                                 const StoredNumbers& numbers) const;

 private:
  SeamSnapper(const TriMesh& mesh, SeamStructure seams, IntegerBasis basis);
  std::vector<Gaussian> round(const std::vector<Vec2>& uv, int exponent, bool isInteger) const;
  std::optional<std::vector<Gaussian>> roundStraight(const std::vector<Vec2>& uv, int exponent,
                                                     bool isInteger) const;

  const TriMesh* mesh_;
  SeamStructure seams_;
  IntegerBasis basis_;
  PerVertex<int> closureOf_;                ///< −1 where a vertex is free
  std::optional<StraightPlaces> straight_;  ///< where there are features
};

/// Snaps a map whose translations are integers up to rounding, as finely as doubles allow; nothing where its
/// seams cannot be read or a triangle would not be positive.
/// @param features  lie on integers up to rounding
std::optional<UvMap> snapAligned(const TriMesh& mesh, UvMap map, int q,
                                 const std::vector<VertexId>& cones,
                                 const std::vector<EdgeId>& features = {});

}  // namespace hgp
