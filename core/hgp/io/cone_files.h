// Reads files that prescribe cones.  Role: bytes → Prescription, in the formats of the module `prescription`
// and in HGP's dialect of OBJ.
#pragma once

#include <string_view>

#include "hgp/io/polygon/obj_text.h"
#include "hgp/prescription/cones.h"

namespace hgp::io {

/// Chooses the format by content and name. `q` is the order for files that give angles only (curvature lists,
/// `_Th_hat`); files that state their own order keep it.
Result<prescription::Prescription> readPrescription(std::string_view name, std::string_view text,
                                                    int q);

/// HGP's `c V A` (cone angle Aπ, k = A·q/2) and `sm F V R` lines of an OBJ; q = 4.
Result<prescription::Prescription> readHgpConeLines(std::string_view text,
                                                    const std::vector<TextSpan>& lines,
                                                    const PolygonMesh& polygons,
                                                    const TriangleCorners& corners);

}  // namespace hgp::io
