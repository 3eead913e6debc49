// Conversions of a written glTF: its side files listed or embedded, its buffers compressed, a GLB stored as a
// .gltf.  Role: for callers that move or publish the file.
#pragma once

#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::api {

/// Names of the side files that a written glTF needs and that are not among `files`; of an OBJ, its material libraries.
/// @param refused  if given, receives the reasons why others, such as those outside the folder, are not read
std::vector<std::string> missingSideFiles(const std::vector<io::OutputFile>& files,
                                          std::vector<std::string>* refused = nullptr);

/// Names of the pictures that a material library of an OBJ refers to.
std::vector<std::string> picturesOfMaterials(io::ByteView library);

/// The main file with its side files, from `files` or by `resolve`, embedded as data URIs; notes name missing images.
Result<io::Written> withEmbedded(std::vector<io::OutputFile> files, const io::Resolver& resolve,
                                 const io::Limits& limits);

/// The same file with its data losslessly compressed by meshopt (EXT_meshopt_compression); the certificate also
/// holds for the decoded data. A note states the sizes. Fails with kUsage where io::compressGltf does.
Result<io::Written> compressed(const std::vector<io::OutputFile>& files,
                               const io::Resolver& resolve, const io::Limits& limits);

/// Whether this build can compress: true for native builds with libmeshoptimizer.
bool canCompress();
/// Whether compressed() takes a glTF with the extensions of this one, told before anything is solved.
Status canCompress(io::ByteView main);

/// The GLB in `files` as a .gltf of this name with a side file; a .gltf is returned unchanged.
Result<io::Written> asGltf(std::vector<io::OutputFile> files, const std::string& name);

}  // namespace hgp::api
