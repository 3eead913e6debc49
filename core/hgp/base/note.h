// Notes: what users are told besides a result, as a code with numbers.  Role: the core says what happened; command line,
// package, page and Python each phrase it for their own users (phrase.h; docs/notes.md lists the codes).
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace hgp {

/// A place on the mesh, or in a file, that a failure or a note points at.
struct Where {
  enum class Kind : std::uint8_t { kVertex, kEdge, kFace, kLoop, kLine, kByte };
  Kind kind;
  std::int64_t id;          ///< vertex / face / loop id, line number or byte offset
  std::int64_t other = -1;  ///< second vertex of an edge

  bool operator==(const Where&) const = default;
};

/// Short stable name used in JSON ("vertex", "edge", "triangle", …).
const char* kindName(Where::Kind kind);

/// A named value of a note: a count, a measurement, or a name from a file or a list of ids.
struct NoteValue {
  std::string name;
  std::variant<long long, double, std::string> value;

  template <std::integral Integer>
  NoteValue(const char* n, Integer v) : name(n), value(static_cast<long long>(v)) {}
  NoteValue(const char* n, double v) : name(n), value(v) {}
  NoteValue(const char* n, std::string v) : name(n), value(std::move(v)) {}
  NoteValue(const char* n, const char* v) : name(n), value(std::string(v)) {}

  bool operator==(const NoteValue&) const = default;
};

/// {code, values, where}. The code is one of the catalogue (phrase.h); it stays what it is when words change.
struct Note {
  std::string code;
  std::vector<NoteValue> values;
  std::vector<Where> where;

  explicit Note(std::string c, std::vector<NoteValue> v = {}, std::vector<Where> w = {})
      : code(std::move(c)), values(std::move(v)), where(std::move(w)) {}

  /// The value of that name, or null.
  const NoteValue* find(std::string_view name) const;
  bool operator==(const Note&) const = default;
};
using Notes = std::vector<Note>;

/// Appends `more` to `notes`.
void addNotes(Notes& notes, Notes more);
/// The first note with that code, or null.
const Note* findNote(const Notes& notes, std::string_view code);

}  // namespace hgp
