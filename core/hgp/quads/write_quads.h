// Quad meshes as files.  Role: OBJ for tools, GLB (two triangles a quad) for a look.
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
