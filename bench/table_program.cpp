#include "table_program.h"

#include <cstdio>
#include <exception>

#include "program.h"

namespace hgp::bench {

void TableProgram::addOptions(CLI::App& app) {
  surfaces.addOptions(app);
  app.add_option("--time-limit", cpuSeconds, "processor time of a surface");
  app.add_option("--json", json, "also write the rows as JSON");
  app.add_option("--markdown", markdown, "also write the tables");
}

bool TableProgram::isUsable() const {
  if (surfaces.isUsable()) return true;
  std::fprintf(stderr, "%s: name a folder of meshes, or --generated N\n", name);
  return false;
}

int TableProgram::finish(const std::string& sums, const SurfaceTable& table) const {
  std::fputs(("\n" + sums).c_str(), stdout);
  const std::string format = std::string("hgp-") + name;
  const bool isSaved = saveText(name, json, toJson(table.rows(), format.c_str()));
  return saveText(name, markdown, sums + "\n" + table.text()) && isSaved ? 0 : 7;
}

int runTableProgram(const char* name, int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name, error.what());
    return 70;
  }
}

}  // namespace hgp::bench
