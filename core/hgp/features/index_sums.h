// Moves units of index until vertices on features have the cones that are prescribed.  Role: a cone on Γ is a sum over sectors
// of different patches, so that a unit goes from patch to patch.
#pragma once

#include "hgp/features/aligned_field.h"

namespace hgp {

/// While the indices of the sectors around a vertex have another sum than the prescribed one (GivenIndices::around), moves a unit along the
/// cheapest path to or from a vertex that lacks or has it. At the vertices between, one sector is given what another loses. These
/// are augmenting paths of a flow between patches, whose sums Gauss–Bonnet prescribes, and vertices: where none is left, the
/// prescription is impossible in integers. That fails with kPrescription; the message has the patches that prove it, and the
/// cones that the field has instead, with their vertices.
/// @pre makeIndicesPossible()
Status makeSumsPossible(const TriMesh& mesh, const Geometry& geometry, AlignedField& field);

}  // namespace hgp
