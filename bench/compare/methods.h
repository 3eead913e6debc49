// Maps one connected surface with one prescription by every method.  Role: the measurements of bench/compare.
#pragma once

#include <cstdint>
#include <string>

#include "hgp/mesh/tri_mesh.h"
#include "surface_rows.h"

namespace hgp::bench {

struct CompareOptions {
  int q = 4;  ///< for automatic cones; random prescriptions have their own
  std::uint64_t seed = 1;
  double methodSeconds = 60.0;  ///< limit on the processor time of each method
};

/// Choices of cones for comparisons: "balanced" (automatic cones) and "low-distortion"; "field" (those
/// of the smoothest field); "orbifold" (four far-apart cones of angle π on a sphere); and the families of
/// bench/stress ("random", "few", "handles", …).
bool isChoice(const std::string& choice);

/// Names of the maps: those of Method, and these.
inline constexpr const char* kNoFrames = "harmonic, no frames";
inline constexpr const char* kConvex = "Tutte, convex boundary";
inline constexpr const char* kCetm = "CETM";

/// All methods with the same completed prescription; no maps if the choice of cones does not apply to the surface.
/// Times are those of whole runs, from the mesh and the prescription to the map.
SurfaceRow compareMethods(const std::string& name, const TriMesh& mesh, const std::string& choice,
                          const CompareOptions& options);

}  // namespace hgp::bench
