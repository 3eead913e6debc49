// The values that the words of options denote.  Role: words → values for the parsers of option objects and command lines.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hgp/api/options.h"

namespace hgp::api {

// The words themselves are those of option_table.h; empty for others. Any thread may call these functions.

std::optional<BoundaryKind> boundaryNamed(std::string_view word);
const char* boundaryName(BoundaryKind boundary);
std::optional<FrameSource> framesNamed(std::string_view word);
std::optional<Scale> scaleNamed(std::string_view word);
std::optional<GridMode> gridModeNamed(std::string_view word);
std::optional<Symmetry> symmetryNamed(std::string_view word);  ///< never kNone
std::optional<MapFormat> mapFormatNamed(std::string_view word);
/// "X", …; "none"
const char* symmetryWord(Symmetry symmetry);
/// LoadOptions::weld for "exact" (0) and "none" (kWeldNever).
std::optional<double> weldNamed(std::string_view word);
/// The balance of ImproveOptions that a word denotes: "isometric" (0), "conformal" (−1), "area" (1) or
/// a number from −1 to 1; empty for other words.
std::optional<double> improveBalance(const std::string& word);
/// The word for a balance; "" for values other than these three.
std::string improveWord(double balance);

}  // namespace hgp::api
