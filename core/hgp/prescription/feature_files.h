// Lists of feature edges in files.  Role: bytes → features, before they are found on a mesh.
#pragma once

#include <string_view>

#include "hgp/base/result.h"
#include "hgp/prescription/prescription.h"

namespace hgp::prescription {

/// Maximum number of edges in one file.
inline constexpr int kMaxFeatures = 10'000'000;

/// `.sharp`: the number of rows, then rows "type,triangle,side", type 0 concave or 1 convex; an edge is listed from either
/// side or from both. `.obj`: its lines "l a b …", polylines through vertices counted from 1. `.json`: the features of
/// hgp-cones. Otherwise rows of two vertices from 0; empty rows and what follows a # are skipped. Fails with kMalformed,
/// and the line.
Result<PrescribedFeatures> readFeatures(std::string_view name, std::string_view text);

/// Adds to the features of a prescription those that a user asks for beside it: a list that was read, whose lines and sides
/// come instead of those before, and rims, an angle and marks. The angle and the marks that are asked for come before those
/// of the prescription, and these before those of the list.
void addFeatures(PrescribedFeatures& features, std::optional<PrescribedFeatures> list,
                 const PrescribedFeatures& asked);

}  // namespace hgp::prescription
