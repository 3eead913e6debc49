// Rounds a map to a dyadic grid so that its seams hold exactly.  Role: (12) of [BCW17] in the stored numbers:
// both sides of every seam satisfy z' = e^{i2πr/q} z + t without any rounding.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "hgp/grid/lattice_snapper.h"

namespace hgp {

/// Rounds maps of one surface with the same seams: as solved, moved or scaled.
/// For q = 1, 2, 4 the stored numbers are points of 2^e Z[i]; for q = 3, 6 they are the numbers nearest to points of
/// 2^e Z[ω], and the seams hold exactly between those points: u = a − b/2 is exact, v the nearest to b √3/2.
class SeamSnapper {
 public:
  /// @param map    positive and seamless up to rounding; @param q  1, 2, 3, 4 or 6
  /// @param cones  vertices with a prescribed cone angle
  /// @param features  edges whose ends get equal u or equal v, whichever is closer to being equal; not for q = 3, 6
  /// @return nothing where q does not allow it or copies do not follow seams (see readSeamsOver)
  static std::optional<SeamSnapper> make(const TriMesh& mesh, const UvMap& map, int q,
                                         const std::vector<VertexId>& cones,
                                         const std::vector<EdgeId>& features = {});

  /// The exponent to try first for these uv; if that does not fit, the next one does.
  int firstExponent(const std::vector<Vec2>& uv, const StoredNumbers& numbers) const;

  /// Rounds vertices to points of 2^exponent times the lattice and translations to multiples of its step (integers are
  /// kept); computes copies and cones z = T/(1 − e^{i2πr/q}) from them in integers. A triangle that this flips
  /// is repaired by moving all copies of one of its vertices together, by a few steps; not of vertices on features.
  /// @param uv  uv of the map, possibly moved or scaled; finite
  /// @return nothing where a number is not exact at this exponent: try the next one
  std::optional<SnappedMap> snap(const std::vector<Vec2>& uv, int exponent,
                                 const StoredNumbers& numbers) const;

 private:
  using Snapper = std::variant<LatticeSnapper<Gaussian>, LatticeSnapper<Eisenstein>>;
  explicit SeamSnapper(Snapper snapper) : snapper_(std::move(snapper)) {}

  Snapper snapper_;
};

/// Snaps a map whose translations are integers up to rounding, as finely as doubles allow; nothing where its
/// seams cannot be read or a triangle would not be positive.
/// @param q         1, 2 or 4
/// @param features  lie on integers up to rounding
std::optional<UvMap> snapAligned(const TriMesh& mesh, UvMap map, int q,
                                 const std::vector<VertexId>& cones,
                                 const std::vector<EdgeId>& features = {});

}  // namespace hgp
