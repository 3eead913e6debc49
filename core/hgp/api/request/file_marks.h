// Edges that a file marks by itself.  Role: lines, smoothing groups, materials and split normals of a document → features.
#pragma once

#include <array>
#include <vector>

#include "hgp/api/model/model.h"
#include "hgp/prescription/prescription.h"

namespace hgp::api {

/// Edges as pairs of surface vertices, smaller first, ascending and without repetition. Between two triangles an edge is
/// marked where they have different materials, different smoothing groups (0 and "off" are one), or where the normals of
/// their corners differ by more than a degree at either end. Lines are taken as they are, whether they are edges or not.
/// Fails with kPrescription where nothing is marked in any of these ways, and where normals differ at more than half of all
/// edges, since the file is then shaded flat.
Result<std::vector<std::array<int, 2>>> markedEdges(const Model& model,
                                                    std::vector<prescription::FeatureMark> marks);

}  // namespace hgp::api
