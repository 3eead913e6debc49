// Frames that somebody else computed.  Role: the field of a file in place of our trivial connection,
// where it realises exactly what is asked: d_j of [BCW17 (13)] and the seam rotations of (12).
#pragma once

#include "hgp/field/read_holonomy.h"

namespace hgp {

/// The field of `data` as frames, and its prescription as specOfField reads it: k_i from what the
/// directions turn around a vertex, l_j around a loop, r along each generator. What `asked` leaves
/// open (turning, handles) is the field's.
/// Fails with kUsage where the data has matchings but no directions, with kPrescription where a cone,
/// turning index or handle rotation of the field is not the asked one (counts, numbers and places in
/// the failure), and as fieldOfFieldData does.
/// @param asked  checkPrescription(asked) passed
Result<ReadField> givenFrames(const TriMesh& mesh, const FieldContext& context,
                              const FieldData& data, const HolonomySpec& asked);

}  // namespace hgp
