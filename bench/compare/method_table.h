// Rows as text for people.  Role: what bench/compare prints.
#pragma once

#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

/// Header of the Markdown table and the lines of a surface, one per method.
std::string methodHead();
std::string methodLines(const SurfaceRow& row);

/// How many each method certifies, per choice of cones, genus 0 and handles apart; then medians of
/// distortion and time beside those of `auto`, over the surfaces that both certify.
std::string methodSummary(const std::vector<SurfaceRow>& rows);

}  // namespace hgp::bench
