// The side files of a written glTF.  Role: for callers who move it elsewhere.
#pragma once

#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::api {

/// Names of the side files that a written glTF needs and that are not among `files`.
std::vector<std::string> missingSideFiles(const std::vector<io::OutputFile>& files);

/// The main file with its side files, from `files` or by `resolve`, inside it as data URIs.
Result<std::vector<io::OutputFile>> withEmbedded(std::vector<io::OutputFile> files,
                                                 const io::Resolver& resolve,
                                                 const io::Limits& limits);

}  // namespace hgp::api
