// Degrades meshes on purpose without changing the surface's topology.  Role: simulates scanners, modellers and
// simplifiers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/mesh/mesh_data.h"
#include "random.h"

namespace hgp::stress {

/// One kind of degradation at one level.
struct Harm {
  std::string kind;    ///< noise, anisotropy, decimation, slivers, spikes, needles
  double level = 0.0;  ///< see degraded()
};

/// Every kind at every level that is measured.
const std::vector<Harm>& harms();

/// noise: every vertex moved by at most `level` mean edges. anisotropy: one axis × level. decimation:
/// random edges collapsed to `level` of the triangles. slivers: up to 100 vertices added at `level` heights
/// from an edge. spikes: ten vertices moved out by `level` mean edges; needles: ten boundary
/// vertices. Connectivity stays manifold. Empty if this kind does not apply to the mesh.
std::optional<MeshData> degraded(const MeshData& mesh, const Harm& harm, Random& random);

}  // namespace hgp::stress
