// Frames from the field of a file.  Role: replaces our trivial connection where the field realises exactly the
// prescription: d_j of [BCW17 (13)] and the seam rotations of (12).
#pragma once

#include "hgp/field/read_holonomy.h"

namespace hgp {

/// The field of `data` as frames, and its prescription as specOfField reads it: k_i from the rotation of the
/// directions around a vertex, l_j around a loop, r along each generator. Turning and handles that `asked` leaves
/// open are those of the field.
/// Fails with kUsage where the data has matchings but no directions, with kPrescription where a cone,
/// turning index or handle rotation of the field is not the asked one (counts, numbers and places in
/// the failure), and as fieldOfFieldData does.
/// @param asked  checkPrescription(asked) passed
Result<ReadField> givenFrames(const TriMesh& mesh, const FieldContext& context,
                              const FieldData& data, const HolonomySpec& asked);

}  // namespace hgp
