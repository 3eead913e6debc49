// One size of automatic cells for all meshes of a file.  Role: a scene in which a pattern is everywhere of one size.
#pragma once

#include <vector>

#include "hgp/io/document.h"
#include "hgp/mesh/box.h"

namespace hgp::api {

/// So many automatic cells lie along the diagonal of a mesh, and at least so many on all of it.
inline constexpr double kCellsAcross = 14.0;
inline constexpr double kFewestCells = 800.0;

/// The edge length of automatic cells by surface, in its own units: as nodes show the surfaces, that of the largest one on
/// its own. {} of a file with one surface.
std::vector<double> cellLengths(const io::Document& document);

}  // namespace hgp::api
