// One mesh of a corpus, from its file to its row in the table.  Role: the measurement of bench/corpus.
#pragma once

#include <string>
#include <vector>

#include "hgp/api/options.h"

namespace hgp::bench {

struct CorpusOptions {
  int q = 4;
  std::string improve;         ///< word of --improve, "": none
  double timeLimit = 0.0;      ///< seconds per mesh; 0 = none
  bool fixDegenerate = false;  ///< remove triangles without area first
  std::string output;          ///< file for the certified map; empty: not written
};

enum class Outcome {
  kCertified,
  kRefused,  ///< not an oriented manifold, or not a mesh: nothing was attempted
  kFailed,   ///< a valid mesh without a certified map
};
const char* outcomeName(Outcome outcome);

/// Numbers over all components: counts and times are sums, μ and area distortion are weighted by
/// triangles, p95 and maximum are those of the worst component.
struct CorpusRow {
  std::string name;  ///< relative to the folder
  int vertices = 0, triangles = 0, components = 0, genus = 0, loops = 0;
  int cones = 0, rounds = 0, flipped = 0;
  Outcome outcome = Outcome::kFailed;
  std::string reason;  ///< why not certified
  double meanMu = 0, p95Mu = 0, maxMu = 0, rmsLogArea = 0;
  double readSeconds = 0;   ///< file, unpacking, welding, topology
  double fieldSeconds = 0;  ///< cones and field
  double cutSeconds = 0;    ///< cut and assembly of the system
  double solveSeconds = 0;  ///< every round: cone program, verify, repair
  double writeSeconds = 0;  ///< writing the certified file, if CorpusOptions::output is set
  double totalSeconds = 0;  ///< everything, with verification of the stored map and the report
  double peakMegabytes = 0;
};

CorpusRow runMesh(const std::string& file, const std::string& name, const CorpusOptions& options);

/// The command that reproduces the row.
std::string reproduction(const std::string& file, const CorpusOptions& options);

}  // namespace hgp::bench
