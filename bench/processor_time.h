// Seconds of processor time since the program began.  Role: other programs on the machine do not count.
#pragma once

#include <ctime>

namespace hgp::bench {

inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace hgp::bench
