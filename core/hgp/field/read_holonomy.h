// The prescription that a field has.  Role: q, C, k_i, l_j and handle rotations of fields and
// matchings made elsewhere [BCW17 §5.2]; stored matchings are the truth.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Angle indices, turning and handle holonomies of a field with matchings.
CompleteSpec specOfField(const TriMesh& mesh, const FieldContext& context, const FrameField& field);

/// The same for plain field data. Where matchings are stored, cones are those congruent to them
/// mod q that the directions (or, without directions, the surface's curvature) come nearest to; a
/// sign convention that does not reproduce `expected` cones is tried both ways and refused when
/// neither fits.
/// @param expected  cones that came with the field, if any
/// Fails with kPrescription (they disagree) or kMalformed (sizes, edges that are not there).
Result<CompleteSpec> specOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                     const FieldData& data,
                                     const std::vector<ConePoint>& expected = {});

}  // namespace hgp
