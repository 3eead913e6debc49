// Quad meshes as files.  Role: OBJ for other programs, GLB (two triangles per quad) for viewers.
#pragma once

#include <cstdint>
#include <string>

#include "hgp/quads/quads.h"

namespace hgp {

/// v, vn and f lines; positions with 17 digits.
std::string quadsAsObj(const QuadMesh& quads, const std::string& comment);

/// One primitive of triangles with normals, float32.
std::vector<std::uint8_t> quadsAsGlb(const QuadMesh& quads, const std::string& generator);

}  // namespace hgp
