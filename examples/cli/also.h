// Further forms of a result, besides the file with the map: --also.  Role: chooses formats by file name.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "arguments.h"
#include "hgp/api/session.h"

namespace hgp::cli {

/// The format that a name denotes: x.glb, x.gltf, x.obj, x.flat.obj, x.svg; empty for other names.
std::optional<api::MapFormat> alsoFormat(const std::string& name);

struct AlsoFile {
  std::string path;
  api::WrittenMap written;
};

/// Makes all files of --also in memory, so that nothing is written if one of them fails.
Result<std::vector<AlsoFile>> makeAlso(const api::Session& session, const Arguments& asked);

/// Writes them and adds lines on each to `lines`.
Status writeAlso(const std::vector<AlsoFile>& files, std::vector<std::string>& lines);

/// --faces: a line for each triangle, numbered from 0: triangle,stretch,log2_area,overlaps.
Status writeFaces(const api::Session& session, const std::string& path);

/// --loops: {"boundaries": [[vertices]], "handles": [[[v, w], edges]]}.
Status writeLoops(const api::Session& session, const std::string& path);

}  // namespace hgp::cli
