#include "hgp/grid/snap.h"

#include "hgp/grid/lattice.h"

namespace hgp {

std::optional<SeamSnapper> SeamSnapper::make(const TriMesh& mesh, const UvMap& map, int q,
                                             const std::vector<VertexId>& cones,
                                             const std::vector<EdgeId>& features) {
  if (q >= 1 && Gaussian::kOrder % q == 0) {
    auto snapper = LatticeSnapper<Gaussian>::make(mesh, map, q, cones, features);
    if (snapper) return SeamSnapper(std::move(*snapper));
  } else if (q >= 1 && Eisenstein::kOrder % q == 0) {
    auto snapper = LatticeSnapper<Eisenstein>::make(mesh, map, q, cones, features);
    if (snapper) return SeamSnapper(std::move(*snapper));
  }
  return {};
}

int SeamSnapper::firstExponent(const std::vector<Vec2>& uv, const StoredNumbers& numbers) const {
  const bool isSquare = std::holds_alternative<LatticeSnapper<Gaussian>>(snapper_);
  return gridExponent(uv, numbers) +
         (isSquare ? Lattice<Gaussian>::kSpareBits : Lattice<Eisenstein>::kSpareBits);
}

std::optional<SnappedMap> SeamSnapper::snap(const std::vector<Vec2>& uv, int exponent,
                                            const StoredNumbers& numbers) const {
  return std::visit([&](const auto& snapper) { return snapper.snap(uv, exponent, numbers); },
                    snapper_);
}

std::optional<UvMap> snapAligned(const TriMesh& mesh, UvMap map, int q,
                                 const std::vector<VertexId>& cones,
                                 const std::vector<EdgeId>& features) {
  if (q < 1 || Gaussian::kOrder % q != 0) return {};
  const std::optional<SeamSnapper> snapper = SeamSnapper::make(mesh, map, q, cones, features);
  if (!snapper) return {};
  StoredNumbers numbers;
  numbers.hasIntegerTranslations = true;
  std::optional<SnappedMap> snapped =
      snapper->snap(map.uv, gridExponent(map.uv, numbers) + 1, numbers);
  if (!snapped || !snapped->notPositive.empty()) return {};
  map.uv = std::move(snapped->uv);
  return map;
}

}  // namespace hgp
