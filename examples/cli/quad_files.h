// The files of `hgp quads`, and what is said of them.
#pragma once

#include <string>
#include <vector>

#include "arguments.h"
#include "hgp/api/session.h"

namespace hgp::cli {

/// The OBJ that is written beside a GLB, which has triangles only: x-quads.obj beside x.glb. Empty for other names.
std::string objBeside(const std::string& output);

struct QuadFiles {
  api::QuadFile quads;                ///< without its bytes
  std::vector<io::OutputFile> files;  ///< the first is asked.output
};

/// Makes the quads of an aligned map in memory, with what finishFiles() adds; beside a GLB also the quads themselves
/// (objBeside) and the materials that they name.
Result<QuadFiles> makeQuadFiles(const api::Session& session, const io::Resolver& resolve,
                                const Arguments& asked);

/// Says on standard error what was written, and how it differs from the cells of the grid.
void reportQuads(const std::string& output, const api::QuadFile& quads);

}  // namespace hgp::cli
