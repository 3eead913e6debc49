// The small values that all JSON documents contain.  Role: private to the sources of api.
#pragma once

#include <concepts>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "hgp/api/model/model.h"
#include "hgp/base/result.h"

namespace hgp::api {

using Json = nlohmann::ordered_json;

/// A member of an object, while its expression is evaluated. Json's own lists make each member an array of two values
/// first, which is most of the code of a document in WebAssembly.
class Member {
 public:
  template <std::integral Integer>
  Member(const char* name, Integer value) : name_(name), value_(static_cast<long long>(value)) {}
  Member(const char* name, bool value) : name_(name), value_(value) {}
  Member(const char* name, double value) : name_(name), value_(value) {}
  Member(const char* name, const char* value) : name_(name), value_(value) {}
  Member(const char* name, const std::string& value) : name_(name), value_(&value) {}
  Member(const char* name, std::nullptr_t) : name_(name) {}
  Member(const char* name, Json&& value) : name_(name), value_(&value) {}

  void addTo(Json& object) const;

 private:
  const char* name_;
  std::variant<std::monostate, bool, long long, double, const char*, const std::string*, Json*>
      value_;
};

Json object(std::initializer_list<Member> members);

/// [{"kind": "edge", "id": 3, "other": 9}, …]
inline Json whereJson(const std::vector<Where>& where, std::size_t most = 1000) {
  Json out = Json::array();
  for (const Where& w : where) {
    if (out.size() >= most) break;
    Json entry = object({{"kind", kindName(w.kind)}, {"id", w.id}});
    if (w.kind == Where::Kind::kEdge) entry["other"] = w.other;
    out.push_back(std::move(entry));
  }
  return out;
}

/// {"code": "crack", "numbers": {"vertices": 8, …}, "words": {…}, "where": […]}; names and lists are words.
inline Json noteJson(const Note& note) {
  Json numbers = Json::object(), words = Json::object();
  for (const NoteValue& v : note.values) {
    if (const auto* text = std::get_if<std::string>(&v.value))
      words[v.name] = *text;
    else if (const auto* whole = std::get_if<long long>(&v.value))
      numbers[v.name] = *whole;
    else
      numbers[v.name] = std::get<double>(v.value);
  }
  return object({{"code", note.code},
                 {"numbers", std::move(numbers)},
                 {"words", std::move(words)},
                 {"where", whereJson(note.where)}});
}

inline Json notesJson(const Notes& notes) {
  Json out = Json::array();
  for (const Note& note : notes) out.push_back(noteJson(note));
  return out;
}

/// @param component  to whose ids the places belong; in the document they are those of the surface
inline Json notesJson(Notes notes, const ModelComponent& component) {
  for (Note& note : notes) toSurfaceIds(component, note.where);
  return notesJson(notes);
}

inline Json failureJson(const Failure& failure) {
  Json json = object({{"code", errorName(failure.code)},
                      {"stage", failure.stage},
                      {"message", failure.message},
                      {"where", whereJson(failure.where)}});
  if (!failure.advice.empty()) json["advice"] = notesJson(failure.advice);
  return json;
}

inline Json optionalNumber(const std::optional<int>& number) {
  return number ? Json(*number) : Json();
}

/// The text of a document. Names from files may have any bytes: those that are not UTF-8 are replaced.
inline std::string textOf(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hgp::api
