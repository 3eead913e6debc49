#include "hgp/system/weights.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// tan(α/2) tends to infinity at flat corners; the bound limits the weight of a single neighbour.
constexpr double kLargestHalfTangent = 1e3;
constexpr double kMinHalfTangent = 1e-6;

}  // namespace

CornerWeights meanValueWeights(const Geometry& geometry, HalfedgeId h) {
  const double t = std::clamp(portable::tan(0.5 * geometry.cornerAngle[h]), kMinHalfTangent,
                              kLargestHalfTangent);
  return {t / std::max(geometry.length[h], 1e-12),
          t / std::max(geometry.length[TriMesh::previous(h)], 1e-12)};
}

}  // namespace hgp
