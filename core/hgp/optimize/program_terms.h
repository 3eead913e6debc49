// The rows of objective and constraints of [BCW17 (11)–(13)].  Role: shared by penaltyForm and exactForm, the two
// ways of reducing the program to its constrained triangles.
#pragma once

#include <vector>

#include "hgp/optimize/frames.h"
#include "hgp/optimize/program_options.h"
#include "hgp/socp/problem.h"
#include "hgp/system/face_rows.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// The input of one program; references are valid during the call of solveProgram.
struct ProgramInput : SeamlessSystem {
  const Frames& frames;
  const ProgramOptions& options;
};

/// The unknown that is held at 0 because a translation of the whole map is free; −1 when none is needed. It is the
/// one where the map is smallest (among those of constrained triangles, if there are any): floating-point numbers
/// near 0 have the finest spacing there, and rows weighted by e^{−u} determine the values around it best.
int pinnedUnknown(const ProgramInput& in);

/// The pinned unknown or, of a patch, everything that is not free.
HeldUnknowns heldUnknowns(const ProgramInput& in);

/// Mean of u over a face's corners; e to that power is the local scale of its triangle.
double faceScale(const ProgramInput& in, FaceId f);

/// f_z and f_z̄ over the unknowns that are not held, ascending. Writes to `rows`, reusing its memory.
void faceRows(const ProgramInput& in, const HeldUnknowns& held, FaceId f, FaceRows& rows);

/// Frame j's condition s = (Re(f_z d̄) − ε, Re f_z̄, Im f_z̄) / e^u over the terms of faceRows.
socp::ConeConstraint frameCondition(const ProgramInput& in, const FaceRows& rows, std::size_t j);

/// The distortion term of one face: with its rows scaled to the result,
///   δ A e^{−2u} (|f_z − e^u d|² + |f_z̄|²) = |f_z|² + |f_z̄|².
void scaleToDistortion(const ProgramInput& in, FaceId f, double delta, FaceRows& rows);

}  // namespace hgp
