// The small values that all JSON documents contain.  Role: private to the sources of api.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "hgp/base/result.h"

namespace hgp::api {

using Json = nlohmann::ordered_json;

inline const char* whereName(Where::Kind kind) {
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
  return "vertex";
}

/// [{"kind": "edge", "id": 3, "other": 9}, …]
inline Json whereJson(const std::vector<Where>& where, std::size_t most = 1000) {
  Json out = Json::array();
  for (const Where& w : where) {
    if (out.size() >= most) break;
    Json entry{{"kind", whereName(w.kind)}, {"id", w.id}};
    if (w.kind == Where::Kind::kEdge) entry["other"] = w.other;
    out.push_back(std::move(entry));
  }
  return out;
}

inline Json failureJson(const Failure& failure) {
  return Json{{"code", errorName(failure.code)},
              {"stage", failure.stage},
              {"message", failure.message},
              {"where", whereJson(failure.where)}};
}

inline Json optionalNumber(const std::optional<int>& number) {
  return number ? Json(*number) : Json();
}

/// The text of a document. Names from files may have any bytes: those that are not UTF-8 are replaced.
inline std::string textOf(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hgp::api
