// Notes as sentences for users of the command line and of the libraries in C++ and Python.  Role: the only place where
// codes become words in the core; package and page have a catalogue of their own (wasm/package/src/lib/phrases.ts).
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hgp/base/note.h"

namespace hgp {

/// A code and its template. In a template
///   {n}              is the value n: whole numbers and names as they are, others with four digits
///   {n:.2e}          is the number n in that format of printf
///   {n|edge|edges}   is "1 edge" or "2 edges", and {n|edge} the same; {n#lies|lie} is the word without the number
///   {@vertex}        are the ids of the places of that kind (vertex, edge, triangle, loop), and {@} those of all; ", …"
///                    follows if the value "more" is not 0
///   [n: text]        is " text" if the value n is there, and neither 0 nor empty; [!n: text] is the opposite
/// Brackets are not nested.
struct Phrase {
  std::string_view code, text;
};

/// The codes of defects, those of maps, and all others. Defects are apart because the core phrases them itself, and only these.
std::span<const Phrase> defectPhrases();
std::span<const Phrase> mapPhrases();
std::span<const Phrase> otherPhrases();

/// The sentence; the code itself if the catalogue does not have it, and "?" for a value that is missing.
std::string phrase(const Note& note);
/// The sentences of several notes, with this between them.
std::string phrase(const Notes& notes, std::string_view between = "; ");
/// The same for notes on defects.
std::string phraseDefects(const Notes& notes);

}  // namespace hgp
