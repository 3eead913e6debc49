// Tables of bench/distortion.  Role: converts rows to Markdown.
#pragma once

#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

/// Header of the Markdown table and the lines of a surface, one per map.
std::string distortionHead();
std::string distortionLines(const SurfaceRow& row);

/// Medians and worst cases of the requested kinds of distortion, as a Markdown table: over surfaces with more
/// than kMeasurableExcess that have a certified plain map and the compared maps.
std::string improvementSummary(const std::vector<SurfaceRow>& rows);
/// The same for choices of cones, compared with those of the smoothest field.
std::string coneSummary(const std::vector<SurfaceRow>& rows);
inline constexpr double kMeasurableExcess = 1e-3;

}  // namespace hgp::bench
