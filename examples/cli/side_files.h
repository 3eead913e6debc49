// The side files of a glTF that is written somewhere else.  Role: no output refers to what is not there.
#pragma once

#include "arguments.h"
#include "hgp/io/document.h"

namespace hgp::cli {

/// Adds what the written glTF needs and what is not beside it: inside it (--embed), or as further files, unless
/// the same bytes are there already. Fails where another file of that name is there (not with --force), and
/// where a side file of the input is missing.
Status addSideFiles(std::vector<io::OutputFile>& files, const io::Resolver& resolve,
                    const Arguments& asked);

}  // namespace hgp::cli
