// stress [DIR]: random prescriptions on generated surfaces or on the meshes of a folder, intact or
// degraded.  Role: measures how often no map is found; prints a command that reproduces each failure.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "collapse.h"
#include "degrade.h"
#include "draw.h"
#include "files.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "program.h"
#include "row_json.h"
#include "stress_table.h"
#include "surfaces.h"

namespace hgp::stress {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string folder, json, markdown, reproducers;
  std::vector<std::string> only, families, repeat;
  std::uint64_t seed = 1;
  int surfaces = 16, draws = 2, maxGenus = 6, maxTriangles = 20000, triangles = 0;
  bool isDamaged = false;
  RunOptions run;
};

struct NamedSurface {
  std::string name;
  MeshData data;
};

bool isWanted(const std::vector<std::string>& wanted, const std::string& name) {
  return wanted.empty() || bench::matchesOneOf(wanted, name);
}

std::vector<NamedSurface> generatedSurfaces(const Arguments& a) {
  std::vector<NamedSurface> found;
  for (int n = 0; n < a.surfaces; ++n) {
    const std::string name = formatText("surface %d", n);
    if (!isWanted(a.only, name)) continue;
    // Every genus: closed, equally often with one hole, and half as often with several.
    const int genus = n % (a.maxGenus + 1), turn = n / (a.maxGenus + 1) % 5;
    const int holes = turn < 2 ? turn : turn == 2 ? 0 : turn == 3 ? 1 : 3;
    found.push_back(
        {name,
         randomSurface(formatText("%llu/%s", static_cast<unsigned long long>(a.seed), name.c_str()),
                       genus, holes)});
  }
  return found;
}

/// The connected usable meshes of a folder; others are skipped.
std::vector<NamedSurface> readSurfaces(const Arguments& a) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(a.folder))
    if (entry.is_regular_file() &&
        isWanted(a.only, entry.path().lexically_relative(a.folder).generic_string()))
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<NamedSurface> found;
  for (const fs::path& file : files) {
    api::LoadOptions load;
    Result<io::FileSet> set = cli::openFiles(file.string(), "", "", load.limits.maxBytes);
    api::Session session;
    if (!set || !session.load(std::move(*set), load)) continue;
    if (session.triangles().size() > 3 * static_cast<std::size_t>(a.maxTriangles)) continue;
    MeshData data;
    for (std::size_t v = 0; 3 * v < session.positions().size(); ++v)
      data.positions.push_back({session.positions()[3 * v], session.positions()[3 * v + 1],
                                session.positions()[3 * v + 2]});
    for (std::size_t t = 0; 3 * t < session.triangles().size(); ++t) {
      const auto corner = [&](std::size_t i) {
        return static_cast<int>(session.triangles()[3 * t + i]);
      };
      data.triangles.push_back({corner(0), corner(1), corner(2)});
    }
    const auto mesh = buildTriMesh(data);
    if (!mesh || computeTopology(*mesh).componentCount != 1) continue;
    found.push_back({file.lexically_relative(a.folder).generic_string(), std::move(data)});
  }
  return found;
}

class Stress {
 public:
  explicit Stress(const Arguments& a) : a_(a) {}

  void onWhole(const NamedSurface& surface) {
    const auto mesh = buildTriMesh(surface.data);
    if (!mesh) return;
    const Topology topology = computeTopology(*mesh);
    if (isWanted(a_.families, "automatic"))
      run({taskName("automatic", surface.name, 0), surface.name, "automatic", surface.data, {}});
    for (const Family family : kFamilies)
      for (int n = 0; isWanted(a_.families, familyName(family)) && n < a_.draws; ++n)
        drawAndRun(familyName(family), family, surface.name, surface.data, *mesh, topology, n);
  }

  void onDamaged(const NamedSurface& surface) {
    for (const Harm& harm : harms()) {
      const std::string kind = formatText("%s %g", harm.kind.c_str(), harm.level);
      if (!isWanted(a_.families, kind)) continue;
      Random random(taskName(kind, surface.name, 0));
      const auto data = degraded(surface.data, harm, random);
      const auto mesh = data ? buildTriMesh(*data) : Result<TriMesh>(Failure{});
      if (data && !mesh)
        std::fprintf(stderr, "%s: not used: %s\n", taskName(kind, surface.name, 0).c_str(),
                     mesh.error().message.c_str());
      if (!mesh) continue;
      run({taskName(kind, surface.name, 0) + "/automatic", surface.name, kind, *data, {}});
      drawAndRun(kind, Family::kRandom, surface.name, *data, *mesh, computeTopology(*mesh), 1);
    }
  }

  const std::vector<Row>& rows() const { return rows_; }
  const std::string& reproducers() const { return reproducers_; }

 private:
  std::string taskName(const std::string& family, const std::string& mesh, int n) const {
    return formatText("%llu/%s/%s/%d", static_cast<unsigned long long>(a_.seed), family.c_str(),
                      mesh.c_str(), n);
  }

  void drawAndRun(const std::string& label, Family family, const std::string& name,
                  const MeshData& data, const TriMesh& mesh, const Topology& topology, int n) {
    const std::string task = taskName(label, name, n);
    if (!isWanted(a_.repeat, task)) return;
    Random random(task);
    const auto spec = draw(mesh, topology, family, random);
    if (spec) run({task, name, label, data, spec});
  }

  void run(const Task& task) {
    if (!isWanted(a_.repeat, task.name)) return;
    rows_.push_back(runApart(task, a_.run));
    std::fputs(lineOf(rows_.back()).c_str(), stderr);
    if (rows_.back().verdict == Verdict::kCertified || a_.reproducers.empty()) return;
    reproducers_ += saveReproducer(task, a_.run, a_.reproducers) + "\n";
  }

  const Arguments& a_;
  std::vector<Row> rows_;
  std::string reproducers_;
};

std::string asJson(const Arguments& a, const std::vector<Row>& rows) {
  nlohmann::json all{{"format", "hgp-stress"}, {"version", 1}, {"seed", a.seed}};
  nlohmann::json& list = all["runs"] = nlohmann::json::array();
  for (const Row& row : rows) list.push_back(toJson(row));
  return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

int run(const Arguments& a) {
  Stress stress(a);
  std::string text;
  bool isSaved = true;
  for (NamedSurface& s : a.folder.empty() ? generatedSurfaces(a) : readSurfaces(a)) {
    if (a.triangles > 0 && static_cast<int>(s.data.triangles.size()) > a.triangles) {
      Random random(s.name);
      s.data = decimated(s.data, a.triangles, random);
    }
    a.isDamaged ? stress.onDamaged(s) : stress.onWhole(s);
    text = a.isDamaged ? harmTable(stress.rows()) : familyTable(stress.rows());
    text += "\n" + stretchTable(stress.rows());
    if (!stress.reproducers().empty())
      text += "\nTo see the failures again:\n" + stress.reproducers();
    // Saved after every surface, so that an interrupted run leaves its results.
    isSaved = bench::saveText("stress", a.json, asJson(a, stress.rows())) &&
              bench::saveText("stress", a.markdown, text) && isSaved;
  }
  std::fputs(text.c_str(), stdout);
  return isSaved ? 0 : 7;
}

int runProgram(int argc, char** argv) {
  Arguments a;
  CLI::App app("Random prescriptions that pass the check, on generated or given surfaces.",
               "stress");
  app.add_option("dir", a.folder, "folder of meshes (default: generated surfaces of every genus)");
  app.add_option("--seed", a.seed, "of surfaces and draws");
  app.add_option("--surfaces", a.surfaces, "how many are generated");
  app.add_option("--max-genus", a.maxGenus, "genus of generated surfaces, about");
  app.add_option("--draws", a.draws, "per family and surface");
  app.add_option("--only", a.only, "surfaces to take, as a pattern: 'surface 3'");
  app.add_option(
      "--family", a.families,
      "automatic, random, few, big, adjacent, near-boundary, handles, many, or 'noise *' …");
  app.add_option("--repeat", a.repeat, "runs to take, by their printed names, as a pattern");
  app.add_option("--max-triangles", a.maxTriangles, "leave out larger meshes of the folder");
  app.add_option("--triangles", a.triangles, "collapse edges of surfaces until so many are left");
  app.add_flag("--damaged", a.isDamaged, "noise, anisotropy, decimation, slivers, spikes, needles");
  app.add_flag_callback(
      "--improve", [&a] { a.run.solve.improve.emplace(); }, "isometric, after the solve");
  app.add_flag("--refine", a.run.solve.refines, "split edges where there is no map");
  app.add_option("--rounds", a.run.solve.maxRounds, "rounds at most");
  app.add_option("--time-limit", a.run.timeLimit, "processor seconds a run");
  app.add_option("--reproducers", a.reproducers, "folder for the meshes and cones of failures");
  app.add_option("--json", a.json, "also write every run");
  app.add_option("--markdown", a.markdown, "also write the tables");
  CLI11_PARSE(app, argc, argv);
  std::error_code error;
  if (!a.folder.empty() && !fs::is_directory(a.folder, error)) {
    std::fprintf(stderr, "stress: %s is no folder\n", a.folder.c_str());
    return 2;
  }
  if (!a.reproducers.empty()) fs::create_directories(a.reproducers, error);
  return run(a);
}

}  // namespace
}  // namespace hgp::stress

int main(int argc, char** argv) {
  try {
    return hgp::stress::runProgram(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stress: %s\n", error.what());
    return 70;
  }
}
