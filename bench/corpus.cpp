// corpus DIR: maps every mesh below a folder with automatic cones and prints a table.  Role: the main measure of
// this project. Every failure is a bug; the last lines give the commands that reproduce it.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "corpus_process.h"
#include "corpus_table.h"
#include "files.h"
#include "program.h"

namespace {

namespace fs = std::filesystem;
using namespace hgp::bench;

struct Arguments {
  std::string folder, json, markdown;
  std::vector<std::string> only, skip;
  CorpusOptions options;
  std::uint64_t largestFile = 0;
};

bool isMesh(const fs::path& file) {
  fs::path name = file.filename();
  if (name.extension() == ".gz") name = name.stem();
  static const char* const kKinds[] = {".obj", ".off", ".ply", ".stl", ".glb", ".gltf"};
  const std::string kind = name.extension().string();
  return std::any_of(std::begin(kKinds), std::end(kKinds),
                     [&](const char* k) { return kind == k; });
}

/// The meshes below a folder, smallest first, so that the table starts immediately.
std::vector<fs::path> meshesBelow(const Arguments& a) {
  std::vector<std::pair<std::uintmax_t, fs::path>> found;
  for (const auto& entry : fs::recursive_directory_iterator(a.folder)) {
    if (!entry.is_regular_file() || !isMesh(entry.path())) continue;
    const std::string name = entry.path().lexically_relative(a.folder).generic_string();
    if (!a.only.empty() && !matchesOneOf(a.only, name)) continue;
    if (matchesOneOf(a.skip, name)) continue;
    if (a.largestFile > 0 && entry.file_size() > a.largestFile) continue;
    found.emplace_back(entry.file_size(), entry.path());
  }
  std::sort(found.begin(), found.end());
  std::vector<fs::path> files;
  files.reserve(found.size());
  for (auto& [size, path] : found) files.push_back(std::move(path));
  return files;
}

int run(const Arguments& a) {
  std::vector<CorpusRow> rows;
  std::string failures, table = tableHead();
  bool isSaved = true;
  std::fputs(table.c_str(), stdout);
  for (const fs::path& file : meshesBelow(a)) {
    const std::string name = file.lexically_relative(a.folder).generic_string();
    std::fprintf(stderr, "%s …\n", name.c_str());
    rows.push_back(runMeshApart(file.string(), name, a.options));
    const std::string line = tableRow(rows.back());
    table += line;
    std::fputs(line.c_str(), stdout);
    std::fflush(stdout);
    if (rows.back().outcome == Outcome::kFailed) {
      failures += reproduction(file.string(), a.options) + "\n";
    }
    // Saved after every mesh, so that an interrupted run leaves its results.
    isSaved = saveText("corpus", a.json, toJson(rows, a.options)) && isSaved;
  }
  const std::string sums = "\n" + totals(rows);
  std::fputs((sums + (failures.empty() ? "" : "\nTo see the failures again:\n" + failures)).c_str(),
             stdout);
  isSaved = saveText("corpus", a.markdown, table + sums) && isSaved;
  return !failures.empty() ? 6 : isSaved ? 0 : 7;
}

int runProgram(int argc, char** argv) {
  Arguments a;
  CLI::App app("Maps every mesh below a folder with automatic cones and prints a table.", "corpus");
  if (const char* shared = std::getenv("HGP_SHARED_MESHES")) a.folder = shared;
  app.add_option("dir", a.folder, "folder (default: $HGP_SHARED_MESHES)");
  app.add_option("--q", a.options.q, "order of the cones")->check(CLI::Range(1, 64));
  app.add_option("--improve", a.options.improve, "isometric, conformal or area")
      ->check(CLI::IsMember({"isometric", "conformal", "area"}));
  app.add_flag("--fix-degenerate", a.options.fixDegenerate, "remove triangles without area first");
  app.add_option("--only", a.only, "names to take, as a pattern: '*torus*'");
  app.add_option("--skip", a.skip, "names to leave out");
  app.add_option("--largest", a.largestFile, "leave out files of more bytes");
  app.add_option("--time-limit", a.options.timeLimit, "seconds per mesh");
  app.add_option("--json", a.json, "also write the rows as JSON");
  app.add_option("--markdown", a.markdown, "also write the table");
  CLI11_PARSE(app, argc, argv);
  std::error_code error;
  if (!fs::is_directory(a.folder, error)) {
    std::fprintf(stderr, "corpus: name a folder of meshes, or set HGP_SHARED_MESHES\n");
    return 2;
  }
  return run(a);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return runProgram(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "corpus: %s\n", error.what());
    return 70;
  }
}
