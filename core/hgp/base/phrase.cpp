#include "hgp/base/phrase.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <optional>

#include "hgp/base/check.h"

namespace hgp {

const NoteValue* Note::find(std::string_view name) const {
  const auto it = std::find_if(values.begin(), values.end(),
                               [&](const NoteValue& v) { return v.name == name; });
  return it == values.end() ? nullptr : &*it;
}

void addNotes(Notes& notes, Notes more) {
  notes.insert(notes.end(), std::make_move_iterator(more.begin()),
               std::make_move_iterator(more.end()));
}

const Note* findNote(const Notes& notes, std::string_view code) {
  const auto it =
      std::find_if(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
  return it == notes.end() ? nullptr : &*it;
}

const char* kindName(Where::Kind kind) {
  switch (kind) {
    case Where::Kind::kVertex:
      return "vertex";
    case Where::Kind::kEdge:
      return "edge";
    case Where::Kind::kFace:
      return "triangle";
    case Where::Kind::kLoop:
      return "loop";
    case Where::Kind::kLine:
      return "line";
    case Where::Kind::kByte:
      return "byte";
  }
  return "";
}

namespace {

double numberOf(const NoteValue& v) {
  if (const auto* whole = std::get_if<long long>(&v.value)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&v.value);
  return real ? *real : 0.0;
}

bool isGiven(const NoteValue* v) {
  if (!v) return false;
  const auto* text = std::get_if<std::string>(&v->value);
  return text ? !text->empty() : numberOf(*v) != 0.0;
}

/// @param format  of printf without the %, for the number; empty: as it is, with four digits
std::string valueText(const NoteValue* v, std::string_view format) {
  if (!v) return "?";
  if (const auto* text = std::get_if<std::string>(&v->value)) return *text;
  const auto* whole = std::get_if<long long>(&v->value);
  if (whole && format.empty()) return std::to_string(*whole);
  std::string pattern = "%";
  pattern += format.empty() ? ".4g" : format;
  char text[64];
  const int length = std::snprintf(text, sizeof text, pattern.c_str(), numberOf(*v));
  return {text, std::min<std::size_t>(static_cast<std::size_t>(std::max(length, 0)), 63)};
}

/// The ids of the places of a kind, "3–9, 4–7, …". @param kind  as in JSON; empty: of every kind
std::string placesText(const Note& note, std::string_view kind) {
  std::string out;
  for (const Where& w : note.where) {
    if (!kind.empty() && kind != kindName(w.kind)) continue;
    if (!out.empty()) out += ", ";
    out += std::to_string(w.id);
    if (w.kind == Where::Kind::kEdge) out += "–" + std::to_string(w.other);
  }
  return isGiven(note.find("more")) ? out + ", …" : out;
}

/// What stands between braces: "n", "n:.2e", "n|edge|edges" or "n#lies|lie".
std::string placeText(const Note& note, std::string_view place) {
  if (place.substr(0, 1) == "@") return placesText(note, place.substr(1));
  const std::size_t end = std::min(place.find_first_of(":|#"), place.size());
  const NoteValue* v = note.find(place.substr(0, end));
  if (end == place.size()) return valueText(v, {});
  const std::string_view rest = place.substr(end + 1);
  if (place[end] == ':') return valueText(v, rest);
  const std::size_t bar = rest.find('|');
  const bool isOne = v && numberOf(*v) == 1.0;
  std::string word(rest.substr(0, bar));
  if (!isOne) word = bar == rest.npos ? word + 's' : std::string(rest.substr(bar + 1));
  return place[end] == '#' ? word : valueText(v, {}) + ' ' + word;
}

std::string filled(const Note& note, std::string_view text);

/// What stands between brackets: "n: text" or "!n: text".
std::string optionalText(const Note& note, std::string_view part) {
  const std::size_t colon = part.find(':');
  if (colon == part.npos) return {};
  const bool isOpposite = part[0] == '!';
  const std::string_view name = part.substr(isOpposite, colon - isOpposite);
  if (isGiven(note.find(name)) == isOpposite) return {};
  return filled(note, part.substr(colon + 1));
}

std::string filled(const Note& note, std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t open = std::min(text.find_first_of("{["), text.size());
    out += text.substr(0, open);
    if (open == text.size()) break;
    const bool isPlace = text[open] == '{';
    const std::size_t close = text.find(isPlace ? '}' : ']', open);
    HGP_CHECK(close != text.npos, "a template closes its brackets: %s", note.code.c_str());
    const std::string_view inside = text.substr(open + 1, close - open - 1);
    out += isPlace ? placeText(note, inside) : optionalText(note, inside);
    text.remove_prefix(close + 1);
  }
  return out;
}

/// Empty if none of these has the code.
std::optional<std::string> phraseOf(const Note& note, std::span<const Phrase> some) {
  const auto it =
      std::find_if(some.begin(), some.end(), [&](const Phrase& p) { return p.code == note.code; });
  if (it == some.end()) return std::nullopt;
  return filled(note, it->text);
}

void append(std::string& out, std::string_view between, const std::string& sentence) {
  if (!out.empty()) out += between;
  out += sentence;
}

}  // namespace

std::string phrase(const Note& note) {
  for (const std::span<const Phrase> some : {otherPhrases(), mapPhrases(), defectPhrases()})
    if (auto sentence = phraseOf(note, some)) return *sentence;
  return note.code;
}

std::string phrase(const Notes& notes, std::string_view between) {
  std::string out;
  for (const Note& note : notes) append(out, between, phrase(note));
  return out;
}

std::string phraseDefects(const Notes& notes) {
  std::string out;
  for (const Note& note : notes)
    append(out, "; ", phraseOf(note, defectPhrases()).value_or(note.code));
  return out;
}

}  // namespace hgp
