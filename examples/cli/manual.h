// The manual page and shell completions, generated from the options.  Role: `hgp manual` and
// `hgp completion SHELL`, whose output the build installs.
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's own
class App;
}

namespace hgp::cli {

/// hgp.1, with the macros of man(7).
std::string manualPage(const CLI::App& app, const std::string& version);

/// For "bash", "zsh" or "fish"; empty for any other word.
std::string completionScript(const CLI::App& app, const std::string& shell);

}  // namespace hgp::cli
