// Notes as JSON and back.  Role: command line, bindings and Python pass on the notes of documents. Any thread may
// call these functions.
#pragma once

#include <string>
#include <string_view>

#include "hgp/base/note.h"

namespace hgp::api {

/// Notes as in the documents: [{"code", "numbers", "words", "where"}, …] (docs/notes.md).
std::string notesDocument(const Notes& notes);
/// phrase() of a note of a document. @pre `note` is one
std::string phraseJson(std::string_view note);

}  // namespace hgp::api
