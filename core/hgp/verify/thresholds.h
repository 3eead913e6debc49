// The tolerances of a certificate.  Role: define "certified"; every certificate reports them.
#pragma once

namespace hgp {

/// The number type that the map is stored in.
enum class Precision { kFloat64, kFloat32 };

/// Accepted residual of every seam edge, relative to its own length, and accepted deviation of every angle sum and
/// turning, in radians. Maps of ordinary range that are stored as doubles are a million times better;
/// one part in a million is below what an eye or a texel can resolve.
inline constexpr double kTolerance = 1e-6;
/// Upper bound of what rounding of stored values may add, relative to a seam edge's own length and
/// in radians. Where float32 is coarser than that, it cannot represent the map.
inline constexpr double kLargestRounding = 1e-2;
/// Residuals up to this many ulps (of double, and the rounding of stored values) of the largest
/// coordinate are due to computing with such numbers: above the tolerance they mean that the number
/// type cannot represent the map, not that the map is wrong.
inline constexpr double kSeamUlps = 16.0;

struct CertifyOptions {
  /// Number type of the file: seam residuals that rounding to it can cause are allowed. uv are verified as given.
  Precision precision = Precision::kFloat64;
  /// Replaces kTolerance; 0 means kTolerance. Raise it only for files whose coordinates were printed
  /// with few digits.
  double tolerance = 0.0;
  /// The grid step that float32 values were rounded to; 0 means the ulp of the largest coordinate.
  double gridStep = 0.0;
  bool isAnyConeAllowed = false;  ///< unlisted vertices may have any k ≥ 1 (asked = measured)
  int placesPerReason = 20;       ///< how many of the worst places a reason names
  bool measuresDistortion =
      true;  ///< false: of it only what the verdict depends on (measureAreaSpan)
};

/// The bounds that a verdict was made with.
struct Thresholds {
  double tolerance = 0;  ///< of a seam edge's residual relative to its length; of angles in radians
  double rounding =
      0;  ///< what storing can add to a seam edge's residual, uv units; 0: not rounded
  double largestRounding = 0;   ///< kLargestRounding, where something was rounded
  double smallestAreaSpan = 0;  ///< minimum accepted DistortionFacts::areaSpan
};

}  // namespace hgp
