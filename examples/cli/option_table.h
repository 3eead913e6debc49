// The options table: every command and option with its placeholder, help text and examples.
// Role: the source of --help, the manual page and shell completions.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace hgp::cli {

/// Words from the command line that are interpreted after parsing.
struct TypedWords {
  std::string mesh, weld, fix, boundary, conesFor, frames, method, scale, uvSet, gridMode, cells,
      symmetric;
  std::vector<std::string> cone, turning, handle;
  std::string topic;  ///< argument of `help`
  std::string shell;  ///< argument of `completion`
};

struct CommandTable {
  std::vector<std::pair<CLI::App*, Command>> commands;
  CLI::App* help = nullptr;
  CLI::App* completion = nullptr;
  CLI::App* manual = nullptr;
};

/// The exit codes as a text table.
const char* exitCodeText();

/// Adds every command to `app`, which stores arguments in `out` and `words`; both must outlive it.
CommandTable addCommands(CLI::App& app, Arguments& out, TypedWords& words);

}  // namespace hgp::cli
