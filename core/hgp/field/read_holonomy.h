// The prescription that a field has.  Role: q, C, k_i, l_j and handle rotations of fields and
// matchings made elsewhere [BCW17 §5.2]; stored matchings are the truth.
#pragma once

#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Angle indices, turning and handle holonomies of a field with matchings.
CompleteSpec specOfField(const TriMesh& mesh, const FieldContext& context, const FrameField& field);

/// A field of a file on its mesh: what it prescribes, and the field itself.
struct ReadField {
  FrameField field;   ///< angles are empty where the file has matchings only
  CompleteSpec spec;  ///< what it prescribes
};

/// Plain field data with its meaning. Where matchings are stored, cones are those congruent to them
/// mod q that the directions (or, without directions, the surface's curvature) come nearest to.
/// Files differ in the sign of a matching: that is meant which reproduces `expected` cones or,
/// without any, has fewer; of two that do alike the one clearly closer to transport, or the stored.
/// @param expected  cones that came with the field, if any
/// Fails with kPrescription (they disagree) or kMalformed (sizes, edges that are not there,
/// directions that are not finite or have no part in their triangle).
Result<ReadField> fieldOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                   const FieldData& data,
                                   const std::vector<ConePoint>& expected = {});

/// Its prescription alone.
Result<CompleteSpec> specOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                     const FieldData& data,
                                     const std::vector<ConePoint>& expected = {});

}  // namespace hgp
