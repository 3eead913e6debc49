// What is done with a result before it is written.  Role: the last step of a glTF; no output refers to what is
// not there.
#pragma once

#include "arguments.h"
#include "hgp/io/document.h"

namespace hgp::cli {

/// A GLB that is to be a .gltf is taken apart, --compress packs the data. Then what the glTF needs and what is
/// not beside it is added: inside it (--embed), or as further files, unless the same bytes are there already.
/// Fails where another file of that name is there (not with --force), and where a side file of the input is
/// missing. What there is to say is added to `notes`.
Status finishFiles(std::vector<io::OutputFile>& files, std::vector<std::string>& notes,
                   const io::Resolver& resolve, const Arguments& asked);

}  // namespace hgp::cli
