// A program that prints a table of surfaces.  Role: the options and the ends that bench/compare and
// bench/distortion have in common.
#pragma once

#include <string>

#include "surface_selection.h"
#include "surface_table.h"

namespace hgp::bench {

struct TableProgram {
  const char* name;  ///< "compare"
  SurfaceSelection surfaces;
  std::string json, markdown;  ///< where to write rows and tables, empty: nowhere
  double cpuSeconds = 600.0;   ///< of a surface

  void addOptions(CLI::App& app);
  /// Whether there is something to run over; says so on stderr where there is not.
  bool isUsable() const;
  /// Prints the sums and writes what was asked for.
  /// @return the exit code: 7 where something could not be written
  int finish(const std::string& sums, const SurfaceTable& table) const;
};

/// main() of such a program: what is thrown ends it with 70.
int runTableProgram(const char* name, int (*run)(int, char**), int argc, char** argv);

}  // namespace hgp::bench
