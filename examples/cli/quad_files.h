// The files of `hgp quads`, and what is said of them.
#pragma once

#include <string>

#include "hgp/api/results.h"

namespace hgp::cli {

/// The OBJ that is written beside a GLB, which has triangles only: x-quads.obj beside x.glb. Empty for other names.
std::string objBeside(const std::string& output);

/// Says on standard error what was written, and how it differs from the cells of the grid.
void reportQuads(const std::string& output, const api::QuadFile& quads);

}  // namespace hgp::cli
