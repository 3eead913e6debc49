// The members of a JSON object of options, checked by the table.  Role: private to options_from_json.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/api/option_table.h"
#include "hgp/api/options_from_json.h"
#include "hgp/base/result.h"

namespace hgp::api {

using OptionJson = nlohmann::ordered_json;

/// The values that are given, by row.
class GivenOptions {
 public:
  /// Fails as optionsFromJson does, but for contradictions.
  static Result<GivenOptions> read(std::string_view text, std::span<const OptionRow> rows,
                                   Spelling spelling);

  /// The value of the row `name`; null if it is absent.
  const OptionJson& at(std::string_view name) const;
  bool has(std::string_view name) const { return !at(name).is_null(); }
  bool isSet(std::string_view name) const { return has(name) && at(name).get<bool>(); }
  std::string word(std::string_view name, const char* otherwise) const {
    return has(name) ? at(name).get<std::string>() : std::string(otherwise);
  }
  /// The value, where it is given.
  template <class T>
  void read(std::string_view name, T& out) const {
    if (has(name)) out = at(name).get<T>();
  }
  /// "cells and grid exclude each other"
  Failure contradiction(std::string_view a, std::string_view b, const std::string& why) const;

 private:
  GivenOptions(std::span<const OptionRow> rows, Spelling spelling)
      : rows_(rows), values_(rows.size()), spelling_(spelling) {}
  Status take(const OptionJson& object, const std::string& before);
  bool isObject(const std::string& name) const;
  Failure unknown(const std::string& name) const;
  std::string nameOf(std::string_view name) const;

  std::span<const OptionRow> rows_;
  std::vector<OptionJson> values_;
  Spelling spelling_;
};

}  // namespace hgp::api
