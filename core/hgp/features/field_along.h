// Computes a cross field along features.  Role: the first step of a map along features; chooses its cones and corners.
#pragma once

#include "hgp/features/aligned_field.h"

namespace hgp {

/// The smoothest field in which the triangles along features are held. Where an index is less than 1 or too large, units
/// are moved between sectors and vertices of the same patch, and the field is fitted to the new integers.
/// Fails with kPrescription, and the places, where a triangle has three feature edges, and where no field has possible
/// indices.
/// @param features  contain all boundary edges
/// @param asked     its cones and corners are indices that are given (givenIndices)
/// @param context   without Laplacian and handles
Result<AlignedField> alignedField(const TriMesh& mesh, const FieldContext& context,
                                  const std::vector<EdgeId>& features,
                                  const HolonomySpec& asked = {});

}  // namespace hgp
