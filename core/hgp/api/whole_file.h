// All meshes of a file, mapped and written.  Role: what `hgp param` does with a file, for every program. Threads
// may do so at the same time, each with a session of its own.
#pragma once

#include <functional>

#include "hgp/api/file_maps.h"

namespace hgp::api {

struct WholeFileOptions {
  SolveOptions solve;  ///< a number of cells is that of all meshes together
  WriteOptions write;
  std::optional<int> q;                            ///< cones stored with another order are not used
  bool ignoresEmbedded = false;                    ///< nor any others
  prescription::PrescribedFeatures features = {};  ///< of every mesh
  std::function<void(int mesh)> onMesh;            ///< called before each
};

/// What happened to one mesh.
struct MeshOutcome {
  int mesh = 0;
  bool isCertified = false;
  bool isAligned = true;           ///< false: a grid was asked for, and the map is not aligned
  std::string report;              ///< hgp-report, or "" after a failure
  std::optional<Failure> failure;  ///< why there is no map
  bool isGood() const { return isCertified && isAligned; }
};

struct FileOutcome {
  std::vector<MeshOutcome> meshes;
  /// Empty if a mesh is not good, unless the options keep going or allow maps that are not certified.
  std::optional<WrittenFile> written;
  std::vector<int> inFile;  ///< the mesh of each of written->mapNotes
  bool isWhole() const;     ///< every mesh is good
};

/// Maps every mesh of the file of a session, with the cones stored in it or automatic ones. Fails with kCancelled, and
/// where the file cannot be written; failures of single meshes are in the outcome.
Result<FileOutcome> parametrizeFile(Session& session, const WholeFileOptions& options);

/// A prescription, or none, with the features of every mesh.
std::optional<prescription::Prescription> withFeatures(
    std::optional<prescription::Prescription> cones, int q,
    const prescription::PrescribedFeatures& features);

/// The cones stored in the loaded mesh, if these options use them.
Result<std::optional<prescription::Prescription>> storedCones(const Session& session,
                                                              std::optional<int> q,
                                                              bool ignoresEmbedded);

}  // namespace hgp::api
