// Everything a cone program needs that does not change from round to round.  Role: the first half of
// the loop in strategy/loop.cpp: holonomy → field → cut → system.
#pragma once

#include <string>
#include <vector>

#include "hgp/field/prepared_surface.h"
#include "hgp/parametrize/parametrization.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

struct SeamlessSetup {
  std::shared_ptr<const FieldContext> context;  ///< possibly without its Laplacian and handles
  PrescribedField field;
  CutMesh cut;
  SeamRotations seams;
  ReducedUnknowns unknowns;
  HarmonicSystem harmonic;
  std::vector<VertexId> cones;
  Notes warnings;
  bool isTooCoarse = false;  ///< no map on this mesh has these angles
};

inline SeamlessSystem systemOf(const TriMesh& mesh, const SeamlessSetup& setup,
                               const SeamRotations& seams, const HarmonicSystem& harmonic) {
  return {mesh, setup.context->geometry, setup.cut, seams, setup.unknowns, harmonic};
}
inline SeamlessSystem systemOf(const TriMesh& mesh, const SeamlessSetup& setup) {
  return systemOf(mesh, setup, setup.seams, setup.harmonic);
}

/// Checks the prescription, completes it, and sets up the system. Appends the stages' times.
/// @param options  its frames, whose field is then used (the cone metric stays our own); progress
Result<SeamlessSetup> prepareSeamless(PreparedSurface& surface, const HolonomySpec& spec,
                                      const ParametrizeOptions& options,
                                      std::vector<StageTime>& times);

/// The parts of it that follow from field and cones.
void cutOpen(const TriMesh& mesh, SeamlessSetup& setup);
void assemble(const TriMesh& mesh, SeamlessSetup& setup);

/// The map as uv per copy: scaled to the surface's area, its box centred at the origin.
UvMap layOut(const TriMesh& mesh, const SeamlessSetup& setup, const std::vector<Complex>& z);

/// The same from its parts (also for maps without seams).
UvMap layOut(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
             const std::vector<Complex>& z);

}  // namespace hgp
