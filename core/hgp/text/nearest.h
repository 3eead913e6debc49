// Suggestions for mistyped words.  Role: usage errors mention the nearest known word.
#pragma once

#include <string>
#include <vector>

namespace hgp::text {

/// The name nearest to a word by edit distance, or starting with it; "" if none is near.
std::string nearestOf(const std::string& word, const std::vector<std::string>& names);

}  // namespace hgp::text
