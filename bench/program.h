// Functions shared by the programs of this folder: name patterns and output files.
#pragma once

#include <string>
#include <vector>

namespace hgp::bench {

/// Whether one of the patterns ("*torus*") matches.
bool matchesOneOf(const std::vector<std::string>& patterns, const std::string& name);

/// Writes text; on failure prints the reason on stderr after the program's name and returns false. An empty path writes
/// nothing.
bool saveText(const char* program, const std::string& path, const std::string& text);

}  // namespace hgp::bench
