// Seconds of processor time since the program started.  Role: times that do not depend on other programs.
#pragma once

#include <ctime>

namespace hgp::bench {

inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace hgp::bench
