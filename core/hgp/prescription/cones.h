// Cones, turnings, handles and fields in the file formats of other programs. Values that are not exact integers are
// refused.  Role: bytes ↔ Prescription.
#pragma once

#include <string>
#include <string_view>

#include "hgp/mesh/topology.h"
#include "hgp/prescription/prescription.h"

namespace hgp::prescription {

/// Accepted distance of k or l to an integer where a file gives angles, in units of 2π/q.
inline constexpr double kAngleIndexTolerance = 1e-6;
/// Maximum number of cones in one file.
inline constexpr int kMaxCones = 1'000'000;

/// `hgp-cones` version 1 (docs/schema/hgp-cones.schema.json).
Result<Prescription> readConesJson(std::string_view json);
/// The JSON text. @param indent  spaces per level; negative: everything on one line
std::string writeConesJson(const Prescription& prescription, int indent = 2);

/// "q N", "cones n" and n lines "vertex k", optionally "matchings m" and m lines "g f i j r".
Result<Prescription> readConesText(std::string_view text);

/// Directional `.sing(s)`: "N n", then n rows "vertex index"; k = N − index.
Result<Prescription> readSings(std::string_view text);

/// CEPS curvatures: rows "vertex curvature" in radians; k = q(1 − κ/2π) must be an integer.
Result<Prescription> readCurvatures(std::string_view text, int q);

/// `_Th_hat`: one total angle per vertex in radians.
Result<Prescription> readTotalAngles(std::string_view text, int q);

/// Cones from interior angles and the turning index l = Σ (π − Θ_v) · q/2π of every loop. A loop's
/// per-vertex angles are not kept (only their sum is a property of the holonomy), and a note says
/// so. Fails with kPrescription, line and value where k or l is not an integer.
/// @param vertexOrigin  vertex of `mesh` → line of the file (0-based); empty: the same
Result<Prescription> reduceTotalAngles(const Prescription& angles, const TriMesh& mesh,
                                       const Topology& topology,
                                       const std::vector<int>& vertexOrigin);

/// Directional `.rawfield`: "N F", then F rows of N vectors, which must be an N-RoSy.
Result<Prescription> readRawField(std::string_view text);
/// VCG `.rosy`: F, N, then F rows of one vector.
Result<Prescription> readRosy(std::string_view text);
/// MIQ `.ffield`: directions and, where stored, matchings.
Result<Prescription> readFField(std::string_view text);

/// Sets `to` of matchings that lack it, using the triangles.
Status completeMatchings(FieldData& field, const std::vector<std::array<int, 3>>& triangles);

}  // namespace hgp::prescription
