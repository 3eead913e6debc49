// Success rates by family and genus, by degradation and by predicted stretch.  Role: the tables of bench/stress.
#pragma once

#include <string>
#include <vector>

#include "stress_run.h"

namespace hgp::stress {

/// A Markdown table. Maps that float64 cannot represent are counted separately, next to the rate.
std::string familyTable(const std::vector<Row>& rows);
std::string harmTable(const std::vector<Row>& rows);
std::string stretchTable(const std::vector<Row>& rows);

/// One line per run.
std::string lineOf(const Row& row);

}  // namespace hgp::stress
