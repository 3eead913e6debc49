// A program that prints a table of surfaces.  Role: the common options and output of bench/compare and
// bench/distortion.
#pragma once

#include <string>

#include "surface_selection.h"
#include "surface_table.h"

namespace hgp::bench {

struct TableProgram {
  const char* name;  ///< "compare"
  SurfaceSelection surfaces;
  std::string json, markdown;  ///< files for rows and tables; empty: not written
  double cpuSeconds = 600.0;   ///< limit for a surface

  void addOptions(CLI::App& app);
  /// Whether there are surfaces; if not, prints an error on stderr.
  bool isUsable() const;
  /// Prints the sums and writes the requested files.
  /// @return the exit code: 7 if a file could not be written
  int finish(const std::string& sums, const SurfaceTable& table) const;
};

/// main() of such a program: an exception ends it with exit code 70.
int runTableProgram(const char* name, int (*run)(int, char**), int argc, char** argv);

}  // namespace hgp::bench
