// How far a map is from preserving angles and areas.  Role: the measurements in the figures of [BCW17 §8],
// weighted by surface area.
#pragma once

#include "hgp/verify/orientation.h"

namespace hgp {

/// Over the positive triangles with area on the surface; weights are surface areas.
struct DistortionFacts {
  int triangleCount = 0;  ///< triangles measured
  double meanMu = 0;      ///< μ = |f_z̄| / |f_z| ∈ [0, 1), 0 = conformal
  double medianMu = 0;    ///< half of the area has at most this
  double p95Mu = 0;       ///< 95 % of the area has at most this
  double maxMu = 0;
  double rmsLogArea = 0;  ///< log₂(uv area / surface area) at the best global scale
  double p95LogArea = 0;  ///< of the absolute value
  double minLogArea = 0, maxLogArea = 0;
  double sizeSpread = 1;  ///< √(uv area / surface area), at 95 % of the surface area over at 5 %
  double symmetricDirichlet = 0;  ///< excess over an isometry at the best global scale, ≥ 0
  double areaSpan = 0;            ///< smallest to mean of uv area per surface area
  double smallestToMeanArea = 0;  ///< smallest to mean uv area
  FaceId worstMu, smallestArea;   ///< where the maximum and the smallest area scale are
};

DistortionFacts measureDistortion(const TriMesh& mesh, const OrientationFacts& orientation,
                                  const CornerUv& uv);

/// The same, but only triangleCount and what a verdict needs: areaSpan, smallestToMeanArea and smallestArea.
DistortionFacts measureAreaSpan(const TriMesh& mesh, const OrientationFacts& orientation,
                                const CornerUv& uv);

}  // namespace hgp
