// Fits the directions of an aligned field to its integers.  Role: after units of index were moved, some matchings turn
// by a quarter turn across one edge; the same turn is then spread over the surface.
#pragma once

#include "hgp/features/aligned_field.h"

namespace hgp {

/// Minimises Σ_e w_e ω_e² over the angles of all triangles off features, with the integers (matchings, axes, and the
/// multiples of 2π in turns and tilts) as they are; triangles along features follow their axes. Changes angles, turns
/// and tilts. Nothing changes where the system cannot be factored.
void fitField(const TriMesh& mesh, const Geometry& geometry, AlignedField& field);

}  // namespace hgp
