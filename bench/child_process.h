// Work in a process of its own.  Role: a crash, a hang or running out of memory is one row of a table
// and not the end of it; and peak memory is that of this work alone.
#pragma once

#include <functional>
#include <string>

#include "hgp/base/result.h"

namespace hgp::bench {

struct ChildLimits {
  double wallSeconds = 0.0;  ///< killed after; 0 = none
  double cpuSeconds = 0.0;   ///< killed after; 0 = none. What counts where a machine is shared
};

/// What work() returned in a forked child. Fails (kInternal) when the child died, naming the signal or
/// its exit code; an exception of work() is its message.
Result<std::string> runInChild(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace hgp::bench
