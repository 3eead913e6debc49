// Runs one draw and measures it.  Role: the measurements of bench/stress.
#pragma once

#include <optional>
#include <string>

#include "hgp/api/options.h"
#include "hgp/mesh/holonomy_spec.h"

namespace hgp::stress {

struct Task {
  std::string name;    ///< "7/random/surface 12/0": seed, family, mesh, number
  std::string mesh;    ///< "surface 12" or a file
  std::string family;  ///< of prescriptions, or kind and level of degradation
  MeshData data;
  std::optional<HolonomySpec> spec;  ///< empty: automatic cones, q = 4
};

enum class Verdict {
  kCertified,
  kTooFine,    ///< all integers are right, but float64 cannot represent the map well enough
  kTooCoarse,  ///< the check or the run proves that the mesh has too few triangles for the angles
  kFailed,
  kLate,     ///< more processor time than allowed
  kCrashed,  ///< or an internal error
};
const char* verdictName(Verdict verdict);

struct Row {
  std::string name, mesh, family, reason;
  Verdict verdict = Verdict::kCrashed;
  int triangles = 0, genus = 0, loops = 0;
  int q = 0, cones = 0, rounds = 0, flipped = 0;
  bool isAutomatic = false, areHandlesGiven = false;
  bool isWarned = false;    ///< a note warned of stretch
  double scaleRange = 0.0;  ///< of the cone metric: max u − min u
  double seconds = 0.0;     ///< processor time of parametrize() and of verifying
  double meanMu = 0.0, rmsLogArea = 0.0, symmetricDirichlet = 0.0;
  std::string method;  ///< of the last round
};

struct RunOptions {
  double timeLimit = 60.0;  ///< processor seconds
  api::SolveOptions solve;  ///< of every run
};

/// Runs a task in a separate process.
Row runApart(const Task& task, const RunOptions& options);

/// Writes FOLDER/…obj and FOLDER/…cones.json; returns the command that reproduces the failure, or why there
/// is none.
std::string saveReproducer(const Task& task, const RunOptions& options, const std::string& folder);

}  // namespace hgp::stress
