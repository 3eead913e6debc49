// compare DIR | --generated N: compares maps with the same cones by our methods, by the programs on which these are
// based, by a harmonic map without frames and by a discrete conformal metric, each measured by the verifier.

#include "method_table.h"
#include "methods.h"
#include "table_program.h"

namespace hgp::bench {
namespace {

int runProgram(int argc, char** argv) {
  TableProgram program{"compare", {}, {}, {}};
  CompareOptions options;
  std::vector<std::string> choices{"balanced"};
  CLI::App app("Methods beside each other, as a table.", program.name);
  program.addOptions(app);
  app.add_option("--cones", choices,
                 "balanced, few, low-distortion, field, orbifold, random, handles, …")
      ->check([](const std::string& choice) {
        return isChoice(choice) ? std::string() : "no choice of cones: " + choice;
      });
  app.add_option("--q", options.q, "order of chosen cones")->check(CLI::Range(1, 64));
  app.add_option("--method-seconds", options.methodSeconds, "processor time of each method");
  CLI11_PARSE(app, argc, argv);
  if (!program.isUsable()) return 2;
  options.seed = program.surfaces.seed;
  SurfaceTable table(methodHead(), methodLines, program.cpuSeconds);
  eachSurface(program.surfaces, [&](const std::string& name, const TriMesh& mesh) {
    for (const std::string& choice : choices) {
      SurfaceRow blank;
      blank.name = name;
      blank.choice = choice;
      blank.triangles = mesh.faceCount();
      table.add(blank, [&] { return compareMethods(name, mesh, choice, options); });
    }
  });
  return program.finish(methodSummary(table.rows()), table);
}

}  // namespace
}  // namespace hgp::bench

int main(int argc, char** argv) {
  return hgp::bench::runTableProgram("compare", hgp::bench::runProgram, argc, argv);
}
