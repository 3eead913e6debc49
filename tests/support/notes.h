// Codes of notes.  Role: tests compare what was noted, and not the words.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/note.h"

namespace hgp::test {

using Codes = std::vector<std::string>;

inline Codes codesOf(const Notes& notes) {
  Codes codes;
  for (const Note& note : notes) codes.push_back(note.code);
  return codes;
}

}  // namespace hgp::test
