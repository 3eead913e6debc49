// What the programs of this folder share.  Role: names as patterns, files that may fail.
#pragma once

#include <string>
#include <vector>

namespace hgp::bench {

/// Does one of the patterns ("*torus*") fit?
bool matchesOneOf(const std::vector<std::string>& patterns, const std::string& name);

/// Written, or said on stderr why not, beginning with the program's name. An empty path is nothing to do.
bool saveText(const char* program, const std::string& path, const std::string& text);

}  // namespace hgp::bench
