// The options table: every command and option, its placeholder, its words of help and its examples.
// Role: --help, the manual page and the completions of shells are all made from it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "arguments.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace hgp::cli {

/// What was typed where a word must still be understood.
struct TypedWords {
  std::string mesh, weld, fix, boundary, conesFor, frames, method, scale, uvSet, gridMode;
  std::vector<std::string> cone, turning, handle;
  std::string topic;  ///< of `help`
  std::string shell;  ///< of `completion`
};

struct CommandTable {
  std::vector<std::pair<CLI::App*, Command>> commands;
  CLI::App* help = nullptr;
  CLI::App* completion = nullptr;
  CLI::App* manual = nullptr;
};

/// The exit codes, as a table of text.
const char* exitCodeText();

/// Adds every command to `app`; what is typed goes to `out` and `words`, which must outlive it.
CommandTable addCommands(CLI::App& app, Arguments& out, TypedWords& words);

}  // namespace hgp::cli
