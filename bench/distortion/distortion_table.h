// Rows as text for people and as JSON for programs.  Role: what bench/distortion prints.
#pragma once

#include <string>
#include <vector>

#include "distortion_run.h"

namespace hgp::bench {

/// Header of the Markdown table and the lines of a surface, one per map.
std::string distortionHead();
std::string distortionLines(const DistortionRow& row);

/// Medians and worst cases of what is asked of the improvement, as a Markdown table: over surfaces with more
/// than kMeasurableExcess, a certified plain map and the maps that are compared.
std::string improvementSummary(const std::vector<DistortionRow>& rows);
/// The same for choices of cones, against those of the smoothest field.
std::string coneSummary(const std::vector<DistortionRow>& rows);
inline constexpr double kMeasurableExcess = 1e-3;

/// Rows as JSON, one or many, and back.
std::string toJson(const DistortionRow& row);
DistortionRow distortionRowFromJson(const std::string& text);
std::string toJson(const std::vector<DistortionRow>& rows);

}  // namespace hgp::bench
