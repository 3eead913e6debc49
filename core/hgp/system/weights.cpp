#include "hgp/system/weights.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// tan(α/2) tends to infinity at flat corners; the bound limits the weight of a single neighbour.
constexpr double kLargestHalfTangent = 1e3;
constexpr double kMinHalfTangent = 1e-6;
/// Cotangents may be negative. A lower bound of 0.05 or 0.001 gives maps of the same distortion.
constexpr double kSmallestCotangent = 0.01;
constexpr double kLargestCotangent = 20.0;

}  // namespace

CornerWeights meanValueWeights(const Geometry& geometry, HalfedgeId h) {
  const double t = std::clamp(portable::tan(0.5 * geometry.cornerAngle[h]), kMinHalfTangent,
                              kLargestHalfTangent);
  return {t / std::max(geometry.length[h], 1e-12),
          t / std::max(geometry.length[TriMesh::previous(h)], 1e-12)};
}

CornerWeights cotangentWeights(const TriMesh& mesh, const Geometry& geometry, HalfedgeId h) {
  const auto half = [&](HalfedgeId edge) {
    const double both =
        oppositeCotangent(geometry, edge) + oppositeCotangent(geometry, mesh.twin(edge));
    return 0.5 * std::clamp(0.5 * both, kSmallestCotangent, kLargestCotangent);
  };
  return {half(h), half(TriMesh::previous(h))};
}

CornerWeights cornerWeights(WeightKind kind, const TriMesh& mesh, const Geometry& geometry,
                            HalfedgeId h) {
  return kind == WeightKind::kCotangent ? cotangentWeights(mesh, geometry, h)
                                        : meanValueWeights(geometry, h);
}

}  // namespace hgp
