// Other forms of a result, beside the map itself: --also.  Role: names become formats.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "hgp/api/session.h"

namespace hgp::cli {

/// What a name asks for: x.glb, x.gltf, x.obj, x.flat.obj, x.svg; nothing for other names.
std::optional<api::MapFormat> alsoFormat(const std::string& name);

struct AlsoFile {
  std::string path;
  api::WrittenMap written;
};

/// All of --also in memory: nothing is written where one of them cannot be made.
Result<std::vector<AlsoFile>> makeAlso(const api::Session& session, const Arguments& asked);

/// Writes them; `notes` takes a line for each.
Status writeAlso(const std::vector<AlsoFile>& files, std::vector<std::string>& notes);

/// --faces: a line for each triangle, from 0: triangle,stretch,log2_area,overlaps.
Status writeFaces(const api::Session& session, const std::string& path);

/// --loops: {"boundaries": [[vertices]], "handles": [[[v, w], edges]]}.
Status writeLoops(const api::Session& session, const std::string& path);

}  // namespace hgp::cli
