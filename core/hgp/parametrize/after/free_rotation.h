// The rotation that seam conditions leave free.  Role: a seamless map may be turned as a whole; here the way the
// surface lies decides, or the directions of a field file, and not the order of its triangles in a file.
#pragma once

#include "hgp/parametrize/after/solution.h"

namespace hgp {

/// The angle θ that turns the map so that rims and creases follow its axes:
///
///   θ = −(1/q) arg Σ_e w_e e^{iq φ_e},   φ_e the direction of edge e in the map,
///   w_e = |e| β_e², β_e the dihedral angle of an interior edge and π/2 on the boundary.
///
/// On smooth surfaces the same sum follows the principal curvatures. Edges have no orientation, so that this needs an
/// even q; for odd q, and where the sum nearly vanishes, the coordinate axes of the surface decide instead of the
/// edges: φ_f is the direction of their projections onto triangle f.
/// @param z  per copy of the cut mesh
double freeRotation(const TriMesh& mesh, const CutMesh& cut, int q, const std::vector<Complex>& z);

/// Turns the solution by freeRotation and verifies its map again.
void turnAsTheSurfaceLies(const TriMesh& mesh, MappedSolution& mapped);

/// Turns the solution by −arg Σ_f A_f e^{i a_f} f_z/|f_z|, a_f the frame of triangle f in the setup, and verifies its map
/// again: on average, given directions are then sent to the positive real axis, whatever frames the map was solved with.
void turnAsFramesSay(const TriMesh& mesh, MappedSolution& mapped);

}  // namespace hgp
