// Rows as text for people.  Role: what bench/distortion prints.
#pragma once

#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

/// Header of the Markdown table and the lines of a surface, one per map.
std::string distortionHead();
std::string distortionLines(const SurfaceRow& row);

/// Medians and worst cases of what is asked of the improvement, as a Markdown table: over surfaces with more
/// than kMeasurableExcess, a certified plain map and the maps that are compared.
std::string improvementSummary(const std::vector<SurfaceRow>& rows);
/// The same for choices of cones, against those of the smoothest field.
std::string coneSummary(const std::vector<SurfaceRow>& rows);
inline constexpr double kMeasurableExcess = 1e-3;

}  // namespace hgp::bench
