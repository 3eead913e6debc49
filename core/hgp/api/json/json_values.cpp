#include "hgp/api/json/json_values.h"

#include <type_traits>
#include <utility>

namespace hgp::api {

void Member::addTo(Json& object) const {
  Json& out = object[name_];
  std::visit(
      [&](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, Json*>)
          out = std::move(*value);
        else if constexpr (std::is_same_v<Value, const std::string*>)
          out = *value;
        else if constexpr (!std::is_same_v<Value, std::monostate>)
          out = value;
      },
      value_);
}

Json object(std::initializer_list<Member> members) {
  Json out = Json::object();
  for (const Member& member : members) member.addTo(out);
  return out;
}

}  // namespace hgp::api
