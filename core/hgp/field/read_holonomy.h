// The prescription that a field has.  Role: q, C, k_i, l_j and handle rotations of fields and
// matchings of other programs [BCW17 §5.2]; stored matchings take precedence over directions.
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

/// Interprets plain field data. Where matchings are stored, k is the index congruent to them
/// mod q that is nearest to the rotation of the directions (or, without directions, to the surface's curvature).
/// Files differ in the sign of a matching: the sign is used that reproduces the `expected` cones or,
/// without any, gives fewer cones; if both do, the one clearly closer to transport, or else the stored sign.
/// @param expected  cones that came with the field, if any
/// Fails with kPrescription (they disagree) or kMalformed (sizes, edges that do not exist,
/// directions that are not finite or have no component in their triangle's plane).
Result<ReadField> fieldOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                   const FieldData& data,
                                   const std::vector<ConePoint>& expected = {});

/// Its prescription alone.
Result<CompleteSpec> specOfFieldData(const TriMesh& mesh, const FieldContext& context,
                                     const FieldData& data,
                                     const std::vector<ConePoint>& expected = {});

}  // namespace hgp
