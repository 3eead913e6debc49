// What can be done with a written glTF: its side files taken along or inside it, its buffers compressed, a GLB
// as a .gltf.  Role: for callers who move it elsewhere.
#pragma once

#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::api {

/// Names of the side files that a written glTF needs and that are not among `files`.
/// @param refused  if given, gets why others are not read: those outside the folder
std::vector<std::string> missingSideFiles(const std::vector<io::OutputFile>& files,
                                          std::vector<std::string>* refused = nullptr);

/// The main file with its side files, from `files` or by `resolve`, inside it as data URIs; notes name images that are missing.
Result<io::Written> withEmbedded(std::vector<io::OutputFile> files, const io::Resolver& resolve,
                                 const io::Limits& limits);

/// The same file with its data compressed by meshopt (EXT_meshopt_compression), without losing a bit: the
/// certificate holds for what is decoded. A note says the sizes. kUnsupported says what stands in the way.
Result<io::Written> compressed(const std::vector<io::OutputFile>& files,
                               const io::Resolver& resolve, const io::Limits& limits);

/// Whether this build compresses: native ones with libmeshoptimizer.
bool canCompress();

/// The GLB in `files` as a .gltf of this name with a side file beside it; a .gltf as it is.
Result<io::Written> asGltf(std::vector<io::OutputFile> files, const std::string& name);

}  // namespace hgp::api
