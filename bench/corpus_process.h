// Runs a mesh in a separate process.  Role: a crash, or running out of memory, affects one row of the table
// only, and peak memory is that of this mesh alone.
#pragma once

#include "corpus_run.h"

namespace hgp::bench {

/// runMesh() in a child process. If the child dies, the row fails with its signal; a child
/// that takes more than twice the time limit is killed.
CorpusRow runMeshApart(const std::string& file, const std::string& name,
                       const CorpusOptions& options);

}  // namespace hgp::bench
