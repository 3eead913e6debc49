// The arguments of a command.  Role: only this parser knows option names; the rest of the program uses structs.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hgp/api/options.h"

namespace hgp::cli {

enum class Command { kInspect, kCheck, kCones, kFeatures, kParam, kQuads, kVerify };

struct Arguments {
  Command command = Command::kInspect;
  std::string input;   ///< "-": standard input
  std::string format;  ///< --format, of standard input
  std::string output;  ///< -o; "-": standard output
  std::string json;    ///< --json; "-": standard output
  std::string xref;
  std::string faces;              ///< a table of the result's triangles
  std::string loops;              ///< inspect: file for boundary loops and generators
  std::vector<std::string> also;  ///< the result in other formats
  std::string root;
  bool isQuiet = false, hasNoProgress = false, mayOverwrite = false;
  std::string color = "auto";
  api::LoadOptions load;
  bool isReproducible = false;
  int threads = 0;            ///< 0: one per processor
  bool isEmbedded = false;    ///< glTF: embeds side files in the main one
  bool isCompressed = false;  ///< glTF: compresses data with meshopt
  bool isEveryMesh = true;    ///< param and verify: process all meshes of the file

  std::optional<int> q;
  prescription::PrescribedFeatures everyMesh;  ///< --rims, --creases and --marked
  std::string features;                        ///< file, of one mesh
  bool hasFeatures() const { return !everyMesh.isEmpty() || !features.empty(); }
  std::string cones, field, convert;    ///< files
  std::string balance, transfer, from;  ///< cones: files, and the mesh of `transfer`
  std::vector<std::pair<int, int>> cone, turning, handle;  ///< V:K, L:J, G:R
  bool ignoresEmbedded = false;
  api::SolveOptions solve;
  std::optional<double> timeLimit;
  api::VerifyOptions verify;
  api::WriteOptions write;
};

/// Either arguments, or the exit code with which the program ends immediately (help, version, usage errors);
/// its text has then been printed.
struct Parsed {
  std::optional<Arguments> arguments;
  int exitCode = 0;
};
Parsed parseArguments(int count, char** words);

}  // namespace hgp::cli
