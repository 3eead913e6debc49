// Rows as JSON and back.  Role: results from child processes, and the output of --json.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "stress_run.h"

namespace hgp::stress {

nlohmann::json toJson(const Row& row);
Row rowFromJson(const nlohmann::json& in);

}  // namespace hgp::stress
