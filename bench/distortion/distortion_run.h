// Maps one connected surface in all ways to be compared.  Role: the measurements of bench/distortion.
#pragma once

#include <string>

#include "hgp/mesh/tri_mesh.h"
#include "surface_rows.h"

namespace hgp::bench {

struct DistortionOptions {
  int q = 4;
  bool hasComparators = true;  ///< SLIM and least-squares conformal maps as well
  double slimSeconds = 60.0;   ///< limit on the processor time of each SLIM run
};

/// Names of the maps.
inline constexpr const char* kPlain = "plain";
inline constexpr const char* kIsometric = "isometric";
inline constexpr const char* kConformal = "conformal";
inline constexpr const char* kSeamlessSlim = "SLIM, seams held";
inline constexpr const char* kFreeSlim = "SLIM, seams free";
inline constexpr const char* kLscm = "LSCM, seams free";

/// With automatic cones: the map as solved and improved, and the other methods on the same cut.
SurfaceRow compareMaps(const std::string& name, const TriMesh& mesh,
                       const DistortionOptions& options);

/// Names of the choices of cones.
inline constexpr const char* kFieldCones = "smooth field";
inline constexpr const char* kFieldCount = "low-distortion, as many";

/// Plain maps with the cones of the smoothest field, of every choice, and of low-distortion with
/// as many cones as the field has.
SurfaceRow compareCones(const std::string& name, const TriMesh& mesh, int q);

}  // namespace hgp::bench
