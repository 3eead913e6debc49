// "Did you mean".  Role: usage errors name the nearest word that there is.
#pragma once

#include <string>
#include <vector>

namespace hgp::cli {

/// The name nearest to a word by edits or as its beginning; "" when none is near.
std::string nearestOf(const std::string& word, const std::vector<std::string>& names);

}  // namespace hgp::cli
