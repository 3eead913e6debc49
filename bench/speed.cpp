// speed [--runs N] [--shared DIR] [--only NAME …]: times of whole runs, from file to certified file, by stage,
// compared with the yardstick of the same mesh measured at the same time. Prints the table of bench/RESULTS.md.

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "corpus_process.h"
#include "files.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "models.h"
#include "yardstick.h"

namespace {

namespace fs = std::filesystem;
using namespace hgp::bench;

struct Case {
  std::string name;
  std::function<hgp::MeshData()> make;  ///< null for a file of the shared folder
};

std::vector<Case> cases() {
  using namespace hgp::models;
  return {{"genus 0, 10 K", [] { return creature(58); }},
          {"genus 5, 10 K", [] { return rings(86); }},
          {"genus 0, 100 K", [] { return creature(182); }},
          {"genus 5, 100 K", [] { return rings(267); }},
          {"10 K boundary edges", [] { return vase(5000, 21); }},
          {"odedstein-meshes/nefertiti-lowres.obj.gz", nullptr},
          {"odedstein-meshes/skull.obj.gz", nullptr},
          {"Directional/Input_wheel.off.gz", nullptr},
          {"gp-js/soccerball.obj.gz", nullptr},
          {"genus 0, 1 M", creatureOfAMillion},
          {"genus 5, 1 M", ringsOfAMillion}};
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

hgp::MeshData meshOf(const std::string& file) {
  hgp::api::Session session;
  hgp::Result<hgp::io::FileSet> files = hgp::cli::openFiles(file, "", "", UINT64_MAX);
  if (!files) throw std::runtime_error(files.error().message);
  hgp::api::LoadOptions load;
  load.limits.maxBytes = UINT64_MAX;
  if (hgp::Status done = session.load(std::move(*files), load); !done)
    throw std::runtime_error(done.error().message);
  hgp::MeshData mesh;
  const auto& p = session.positions();
  for (std::size_t i = 0; i + 2 < p.size(); i += 3)
    mesh.positions.push_back({p[i], p[i + 1], p[i + 2]});
  const auto& t = session.triangles();
  for (std::size_t i = 0; i + 2 < t.size(); i += 3)
    mesh.triangles.push_back(
        {static_cast<int>(t[i]), static_cast<int>(t[i + 1]), static_cast<int>(t[i + 2])});
  return mesh;
}

void measure(const std::string& name, const std::string& file, const std::string& output,
             int runs) {
  const hgp::MeshData mesh = meshOf(file);
  std::vector<CorpusRow> rows;
  std::vector<double> ratio, yards;
  for (int i = 0; i < runs; ++i) {
    CorpusOptions options;
    options.output = output;
    yards.push_back(measureYardstick(mesh).total());
    rows.push_back(runMeshApart(file, name, options));
    ratio.push_back(rows.back().totalSeconds / yards.back());
  }
  const auto of = [&](double CorpusRow::*column) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const CorpusRow& row : rows) values.push_back(row.*column);
    return median(values);
  };
  const CorpusRow& last = rows.back();
  std::printf(
      "| %s | %d | %d | %d | %d | %s | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | "
      "%.1f | %.0f |\n",
      name.c_str(), last.triangles, last.genus, last.loops, last.cones, outcomeName(last.outcome),
      of(&CorpusRow::readSeconds), of(&CorpusRow::fieldSeconds), of(&CorpusRow::cutSeconds),
      of(&CorpusRow::solveSeconds), of(&CorpusRow::writeSeconds), of(&CorpusRow::totalSeconds),
      median(yards), median(ratio), of(&CorpusRow::peakMegabytes));
  std::fflush(stdout);
}

void saveObj(const hgp::MeshData& mesh, const std::string& path) {
  const hgp::io::Bytes bytes = hgp::io::writePlainObj(mesh, {}, "hgp bench/speed");
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (hgp::Status done = hgp::cli::writeText(path, text); !done)
    throw std::runtime_error(done.error().message);
}

int run(int argc, char** argv) {
  int runs = 3;
  std::string shared;
  std::vector<std::string> only;
  if (const char* folder = std::getenv("HGP_SHARED_MESHES")) shared = folder;
  CLI::App app("Times whole runs against one CHOLMOD factorization of the same mesh.", "speed");
  app.add_option("--runs", runs, "the median of this many")->check(CLI::Range(1, 99));
  app.add_option("--shared", shared, "folder of real meshes (default: $HGP_SHARED_MESHES)");
  app.add_option("--only", only, "rows whose name contains one of these");
  CLI11_PARSE(app, argc, argv);
  const fs::path folder = fs::temp_directory_path() / hgp::formatText("hgp-speed-%d", getpid());
  fs::create_directories(folder);
  std::printf(
      "| mesh | F | g | loops | cones | verdict | read s | field s | cut s | solve s | "
      "write s | total s | Y s | total/Y | MB |\n"
      "|---|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const Case& c : cases()) {
    if (!only.empty() && std::none_of(only.begin(), only.end(), [&](const std::string& part) {
          return c.name.find(part) != std::string::npos;
        }))
      continue;
    std::string file = (folder / "in.obj").string();
    if (c.make) {
      saveObj(c.make(), file);
    } else {
      file = (fs::path(shared) / c.name).string();
      if (shared.empty() || !fs::exists(file)) {
        std::printf("| %s | SKIPPED: no such file in the shared folder |\n", c.name.c_str());
        continue;
      }
    }
    measure(c.name, file, (folder / "out.obj").string(), runs);
  }
  fs::remove_all(folder);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "speed: %s\n", error.what());
    return 70;
  }
}
