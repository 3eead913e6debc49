#include "hgp/api/json/json_values.h"
#include "hgp/api/notes.h"
#include "hgp/base/phrase.h"

namespace hgp::api {
namespace {

std::optional<Where> whereOf(const Json& json) {
  using Kind = Where::Kind;
  for (const Kind kind :
       {Kind::kVertex, Kind::kEdge, Kind::kFace, Kind::kLoop, Kind::kLine, Kind::kByte})
    if (json["kind"] == kindName(kind))
      return Where{kind, json["id"].get<std::int64_t>(), json.value("other", std::int64_t{-1})};
  return {};
}

}  // namespace

std::string notesDocument(const Notes& notes) { return textOf(notesJson(notes)); }

std::string phraseJson(std::string_view text) {
  const Json json = Json::parse(text);
  Note note(json["code"].get<std::string>());
  for (const auto& [name, number] : json["numbers"].items())
    if (number.is_number_integer())
      note.values.push_back({name.c_str(), number.get<long long>()});
    else if (number.is_number())
      note.values.push_back({name.c_str(), number.get<double>()});
  for (const auto& [name, word] : json["words"].items())
    note.values.push_back({name.c_str(), word.get<std::string>()});
  for (const Json& place : json["where"])
    if (const std::optional<Where> where = whereOf(place)) note.where.push_back(*where);
  return phrase(note);
}

}  // namespace hgp::api
