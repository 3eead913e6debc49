// Options of a call from a JSON object.  Role: what bindings of other languages pass; values are checked by the table of
// option_table.h, and a wrong one is refused by its name.
#pragma once

#include <string_view>

#include "hgp/api/options.h"
#include "hgp/base/result.h"

namespace hgp::api {

/// How names and values are written, in the object and in messages.
enum class Spelling {
  kJson,    ///< {"maxRounds": 8, "grid": {"cells": 400}}
  kPython,  ///< {"max_rounds": 8, "cells": 400}
};

/// Options that are absent or null keep their defaults. `fix` lists the repairs to make, and no others are made: an empty
/// list is the same as `strict` (LoadOptions::isStrict). `grid.mode` alone chooses the number of cells.
/// Fails with kUsage, naming the option and the nearest known one, for unknown names, values of the wrong type or outside
/// their bounds, contradictions, and texts that are not JSON objects; `stage` is "type" if a value has the wrong type.
/// Any thread may call it.
template <class Options>
Result<Options> optionsFromJson(std::string_view json, Spelling spelling = Spelling::kJson);
template <>
Result<LoadOptions> optionsFromJson(std::string_view json, Spelling spelling);
template <>
Result<SolveOptions> optionsFromJson(std::string_view json, Spelling spelling);
template <>
Result<VerifyOptions> optionsFromJson(std::string_view json, Spelling spelling);
template <>
Result<WriteOptions> optionsFromJson(std::string_view json, Spelling spelling);

}  // namespace hgp::api
