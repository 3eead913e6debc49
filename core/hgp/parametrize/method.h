// The methods by name.  Role: `--method`; restricts what the strategy tries.
#pragma once

#include <optional>
#include <string_view>

namespace hgp {

/// How a map is computed. kAuto combines the others, each of which tries nothing else.
enum class Method {
  kAuto,  ///< harmonic, then soft and hard constraints with repairs, then untangling (docs/decisions/032, 071)
  kHarmonic,  ///< harmonic; then hard frame constraints on F_cb with the least harmonic energy
  kSoft,      ///< soft frame constraints (linear systems); hard ones where the map is wrong
  /// (11)–(13) as printed but for the tie-break of PenaltyObjective, with frames and weights of the failed map for the
  /// next program
  kPrinted,
  kAllFrames,  ///< hard frame constraints on every triangle (bounded distortion)
};
const char* methodName(Method method);  ///< "auto", "harmonic", "soft", "printed", "all-frames"
std::optional<Method> methodNamed(std::string_view name);

}  // namespace hgp
