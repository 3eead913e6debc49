// Processes every mesh of a file.  Role: `param` and `verify` for files with several meshes.
#pragma once

#include <string>
#include <vector>

#include "arguments.h"
#include "hgp/api/session.h"

namespace hgp::cli {

/// The outcome for one mesh: its document, or the failure.
struct MeshOutcome {
  int mesh = 0;
  bool isCertified = false;
  bool isAligned = true;  ///< false where a grid was asked for and the map is not on it
  std::string json;       ///< hgp-report or hgp-certificate
  std::optional<Failure> failure;
};

struct FileOutcome {
  std::vector<MeshOutcome> meshes;
  std::vector<io::OutputFile> files;  ///< param: the file with all maps that may be written
  std::vector<std::string> notes;     ///< of the writer, each with its meshes

  int certifiedCount() const;
  /// Certified and, where a grid was asked for, aligned.
  int goodCount() const;
  /// "hgp-file", see docs/schema.
  std::string json() const;
  /// A line per mesh, with the reason if it is not certified; then the notes.
  std::string text() const;
};

/// Solves the meshes of the loaded file in order and writes all maps at once. A mesh whose map is not
/// certified, or not on the grid that was asked for, is not changed, unless `--keep-going` or `--allow-uncertified` is
/// given. A number of cells is that of all meshes together: their cells have the same size.
/// Ends early when `progress` returns false.
Result<FileOutcome> parametrizeAll(api::Session& session, const Arguments& asked,
                                   const Progress& progress);
Result<FileOutcome> verifyAll(api::Session& session, const Arguments& asked);

}  // namespace hgp::cli
