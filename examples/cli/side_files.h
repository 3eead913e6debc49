// Final conversions of a result before it is written.  Role: ensures that no written glTF refers to missing files.
#pragma once

#include "arguments.h"
#include "hgp/io/document.h"

namespace hgp::cli {

/// Converts a GLB to a .gltf if requested, and compresses the data for --compress. Then adds the side files that the
/// glTF needs: embedded (--embed), or as further files, unless the output folder already has the same bytes.
/// Fails if another file of that name exists (except with --force), and if a side file of the input is missing.
/// Adds notes for users to `notes`.
Status finishFiles(std::vector<io::OutputFile>& files, Notes& notes, const io::Resolver& resolve,
                   const Arguments& asked);

/// Before anything is solved: whether finishFiles() will refuse what the input's side files and extensions ask for.
Status checkSideFiles(io::FileSet& input, const Arguments& asked);

}  // namespace hgp::cli
