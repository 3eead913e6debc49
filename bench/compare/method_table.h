// Tables of bench/compare.  Role: converts rows to Markdown.
#pragma once

#include <string>
#include <vector>

#include "surface_rows.h"

namespace hgp::bench {

/// Header of the Markdown table and the lines of a surface, one per method.
std::string methodHead();
std::string methodLines(const SurfaceRow& row);

/// How many maps each method certifies, per choice of cones, separately for genus 0 and higher genus; then medians of
/// distortion and time compared with `auto`, over the surfaces that both certify.
std::string methodSummary(const std::vector<SurfaceRow>& rows);

}  // namespace hgp::bench
