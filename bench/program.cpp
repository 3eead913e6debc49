#include "program.h"

#include <fnmatch.h>

#include <algorithm>
#include <cstdio>

#include "files.h"

namespace hgp::bench {

bool matchesOneOf(const std::vector<std::string>& patterns, const std::string& name) {
  return std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  });
}

bool saveText(const char* program, const std::string& path, const std::string& text) {
  const Status saved = path.empty() ? Status(Done{}) : cli::writeText(path, text);
  if (!saved) std::fprintf(stderr, "%s: %s\n", program, saved.error().message.c_str());
  return saved.hasValue();
}

}  // namespace hgp::bench
