// How exact a map must be.  Role: the numbers behind "certified"; all of them are reported.
#pragma once

namespace hgp {

/// The number type that the map is stored in.
enum class Precision { kFloat64, kFloat32 };

/// Every seam edge must fit within this part of its own length, every angle sum and every turning
/// within this many radians. Where sums and copies are computed in doubles of ordinary range they are
/// a million times better; one part in a million is below what an eye or a texel can see.
inline constexpr double kTolerance = 1e-6;
/// Most that the rounding of stored values may add to that, relative to a seam edge's own length and
/// in radians. Where float32 is coarser than that, it does not hold the map.
inline constexpr double kLargestRounding = 1e-2;
/// Residuals up to this many ulps (of double, and the rounding of stored values) of the largest
/// coordinate come from computing with such numbers: beyond the tolerance they mean that the number
/// type cannot hold the map, not that it is wrong.
inline constexpr double kSeamUlps = 16.0;

struct CertifyOptions {
  /// Of the file: what rounding to it can do to seams is allowed. uv are verified as they are given.
  Precision precision = Precision::kFloat64;
  /// In place of kTolerance; 0 means kTolerance. Raise it only for files whose coordinates were printed
  /// with few digits.
  double tolerance = 0.0;
  /// The grid step that float32 values were rounded to; 0 means the ulp of the largest coordinate.
  double gridStep = 0.0;
  bool isAnyConeAllowed = false;  ///< unlisted vertices may have any k ≥ 1 (asked = measured)
  int placesPerReason = 20;       ///< how many of the worst places a reason names
};

/// The numbers that the verdict was made with.
struct Thresholds {
  double tolerance = 0;  ///< of a seam edge's own length; radians
  double rounding = 0;   ///< of storing, at one seam edge, in uv units; 0 where nothing was rounded
  double largestRounding = 0;   ///< kLargestRounding, where something was rounded
  double smallestAreaSpan = 0;  ///< least accepted DistortionFacts::areaSpan
};

}  // namespace hgp
