// Documents whose longest members are written element by element.  Role: for a map of many components the documents are
// most of the memory of a run, as trees several times their text.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/api/json/json_values.h"

namespace hgp::api {

/// Takes the place of a member with the value `mark`, a string that nothing after it in the document equals.
struct SplicedMember {
  std::string mark;
  std::size_t size = 0;  ///< about as many bytes
  /// Appends the value, whose lines are indented by so many levels beyond those of its document.
  std::function<void(std::string&, std::size_t)> append;
};

/// A document and its spliced members, in the order in which they are there.
struct SplicedDocument {
  Json json;
  std::vector<SplicedMember> members;

  /// As textOf() would give it.
  std::string text() const;
  void appendTo(std::string& out, std::size_t levels) const;
  std::size_t size() const;  ///< about
};

/// Documents as members of another one.
SplicedMember documentMember(std::string mark, SplicedDocument document);
SplicedMember textMember(std::string mark, const std::string& document);
/// An array of documents, each of which is made when it is written.
SplicedMember arrayMember(std::string mark, std::size_t count,
                          std::function<Json(std::size_t)> element);

/// The text of a document that is the last member of `text`.
std::string lastDocument(std::string_view text, std::string_view key);

}  // namespace hgp::api
