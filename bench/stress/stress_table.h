// Success by family and genus, by harm and by predicted stretch.  Role: what bench/stress prints.
#pragma once

#include <string>
#include <vector>

#include "stress_run.h"

namespace hgp::stress {

/// Markdown. Maps that float64 cannot hold are counted apart, beside the share.
std::string familyTable(const std::vector<Row>& rows);
std::string harmTable(const std::vector<Row>& rows);
std::string stretchTable(const std::vector<Row>& rows);

/// One line a run.
std::string lineOf(const Row& row);

}  // namespace hgp::stress
