// Every mesh of a file, one after the other.  Role: what `param` and `verify` do where a file has several.
#pragma once

#include <string>
#include <vector>

#include "arguments.h"

namespace hgp::cli {

/// What became of one mesh: a document of it, or why there is none.
struct MeshOutcome {
  int mesh = 0;
  bool isCertified = false;
  std::string json;  ///< hgp-report or hgp-certificate
  std::optional<Failure> failure;
};

struct FileOutcome {
  std::vector<MeshOutcome> meshes;
  std::vector<io::OutputFile> files;  ///< of param: the file with every map that may be written
  std::vector<std::string> notes;     ///< of the writer, each with its mesh

  int certifiedCount() const;
  /// "hgp-file", see docs/schema.
  std::string json() const;
  /// A line per mesh, with the reason where one is not certified.
  std::string text() const;
};

/// Solves mesh after mesh and writes each into what the one before has written. A mesh that is not
/// certified is left as it was, unless `--keep-going` or `--allow-uncertified` stores what there is.
/// Ends early when `progress` says stop.
Result<FileOutcome> parametrizeAll(const io::FileSet& files, int meshCount, const Arguments& asked,
                                   const Progress& progress);
Result<FileOutcome> verifyAll(const io::FileSet& files, int meshCount, const Arguments& asked);

}  // namespace hgp::cli
