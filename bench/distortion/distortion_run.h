// One connected surface, mapped in every way that is compared.  Role: the measurement of bench/distortion.
#pragma once

#include <string>
#include <vector>

#include "hgp/mesh/tri_mesh.h"
#include "hgp/verify/certificate.h"

namespace hgp::bench {

struct DistortionOptions {
  int q = 4;
  bool hasComparators = true;  ///< SLIM and least-squares conformal maps as well
  double slimSeconds = 60.0;   ///< processor time of each SLIM
};

/// One map, as the verifier measures it.
struct MeasuredMap {
  std::string name;
  int cones = 0;
  bool isCertified = false;  ///< where it has seams to certify
  int flipped = 0;           ///< triangles that are not positive; the rest is measured without them
  double meanMu = 0, p95Mu = 0;
  double sigma = 0;   ///< standard deviation of log₂ of the area scale
  double excess = 0;  ///< symmetric Dirichlet above an isometry's 4, at the best global scale
  int steps = 0;
  double seconds = 0;  ///< processor time; of a descent what it adds to the plain run
  std::string note;
};

struct DistortionRow {
  std::string name, failure;
  int triangles = 0, genus = 0, loops = 0, q = 0;
  std::vector<MeasuredMap> maps;

  const MeasuredMap* find(const std::string& map) const;
};

/// Names of the maps.
inline constexpr const char* kPlain = "plain";
inline constexpr const char* kIsometric = "isometric";
inline constexpr const char* kConformal = "conformal";
inline constexpr const char* kSeamlessSlim = "SLIM, seams held";
inline constexpr const char* kFreeSlim = "SLIM, seams free";
inline constexpr const char* kLscm = "LSCM, seams free";

MeasuredMap measured(const std::string& name, const Certificate& certificate);

/// Automatic cones; the map as solved and improved, and the comparators on the same cut.
DistortionRow compareMaps(const std::string& name, const TriMesh& mesh,
                          const DistortionOptions& options);

/// Names of the choices of cones.
inline constexpr const char* kFieldCones = "smooth field";
inline constexpr const char* kFieldCount = "low-distortion, as many";

/// Plain maps with the cones of the smoothest field, of every choice, and of low-distortion with
/// as many cones as the field has.
DistortionRow compareCones(const std::string& name, const TriMesh& mesh, int q);

}  // namespace hgp::bench
