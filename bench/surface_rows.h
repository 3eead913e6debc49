// Measurements of the maps of one connected surface by the verifier.  Role: the rows of bench/distortion and
// bench/compare.
#pragma once

#include <string>
#include <vector>

#include "hgp/verify/certificate.h"

namespace hgp::bench {

/// One map.
struct MeasuredMap {
  std::string name;
  std::string verdict;  ///< "certified", or briefly why not
  int cones = 0;
  bool isCertified = false;
  int flipped = 0;      ///< triangles that are not positive; distortion is measured without them
  int wrongAngles = 0;  ///< vertices and loops
  double meanMu = 0, p95Mu = 0;
  double sigma = 0;    ///< standard deviation of log₂ of the area scale
  double excess = 0;   ///< symmetric Dirichlet energy minus 4, at the best global scale
  int steps = 0;       ///< steps of a descent, or programs of a solve
  double seconds = 0;  ///< processor time; of a descent, in addition to the plain run
  std::string note;
};

struct SurfaceRow {
  std::string name, failure;
  std::string choice;  ///< of cones, if there is more than one
  int triangles = 0, genus = 0, loops = 0, q = 0;
  std::vector<MeasuredMap> maps;

  const MeasuredMap* find(const std::string& map) const;
};

MeasuredMap measured(const std::string& name, const Certificate& certificate);

/// "certified", "3 flipped, 1 angle", "seams open", "beyond float64", "no map".
std::string verdictOf(const Certificate& certificate);

/// Rows as JSON, one or many, and back.
std::string toJson(const SurfaceRow& row);
SurfaceRow surfaceRowFromJson(const std::string& text);
std::string toJson(const std::vector<SurfaceRow>& rows, const char* format);

}  // namespace hgp::bench
