// A number with its noun.  Role: singular and plural in messages.
#pragma once

#include <string>

namespace hgp {

/// "1 edge", "2 edges"; give `many` if the plural is not `one` + "s". Any integer type.
template <class Integer>
std::string counted(Integer n, const char* one, const char* many = nullptr) {
  const std::string text = std::to_string(n) + ' ' + (n == 1 || !many ? one : many);
  return n == 1 || many ? text : text + 's';
}

}  // namespace hgp
