// Rows of tables as JSON and back.  Role: a table lists its columns once, as
// `eachColumn(row, visit)` that calls visit(name, member) for each.
#pragma once

#include <nlohmann/json.hpp>

namespace hgp::bench {

template <class Row, class Each>
nlohmann::json columnsOf(const Row& row, const Each& eachColumn) {
  nlohmann::json out;
  eachColumn(row, [&](const char* name, const auto& member) { out[name] = member; });
  return out;
}

template <class Row, class Each>
void readColumns(const nlohmann::json& in, Row& row, const Each& eachColumn) {
  eachColumn(row, [&](const char* name, auto& member) {
    const nlohmann::json& value = in.at(name);
    if (!value.is_null()) value.get_to(member);  // JSON has null for numbers that are not finite
  });
}

}  // namespace hgp::bench
