// A mesh in a process of its own.  Role: a crash, or running out of memory, is one row of the table
// and not the end of it; and peak memory is that of this mesh alone.
#pragma once

#include "corpus_run.h"

namespace hgp::bench {

/// runMesh() in a child process. A child that dies makes a failed row that names the signal; one
/// that takes more than twice the time limit is killed.
CorpusRow runMeshApart(const std::string& file, const std::string& name,
                       const CorpusOptions& options);

}  // namespace hgp::bench
