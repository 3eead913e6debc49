// The roads to a map, by name.  Role: `--method`, and what the strategy may do.
#pragma once

#include <optional>
#include <string_view>

namespace hgp {

/// Which road is taken. All but kAuto stay on theirs.
enum class Method {
  kAuto,  ///< what measurements support: soft, then hard constraints with repairs, then untangling
  kHarmonic,  ///< hard frame constraints on F_cb, rows weighted by e^{−u}: harmonic where it can be
  kSoft,      ///< soft frame constraints: linear programs, hard ones where the map went wrong
  kPrinted,  ///< (11)–(13) as printed, frames and weights of the failed map for the next program
  kAllFrames,  ///< hard frame constraints on every triangle (bounded distortion)
};
const char* methodName(Method method);  ///< "auto", "harmonic", "soft", "printed", "all-frames"
std::optional<Method> methodNamed(std::string_view name);

}  // namespace hgp
