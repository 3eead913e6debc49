// Work in a separate process.  Role: a crash, a hang or running out of memory affects one row of a table
// only, and peak memory is that of this work alone.
#pragma once

#include <functional>
#include <string>

#include "hgp/base/result.h"

namespace hgp::bench {

struct ChildLimits {
  double wallSeconds = 0.0;  ///< killed after this time; 0: no limit
  double cpuSeconds = 0.0;   ///< killed after this processor time, for shared machines; 0: no limit
};

/// The result of work() in a forked child. Fails with kInternal and the signal or exit code if the child died, or with
/// the message of an exception thrown by work().
Result<std::string> runInChild(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace hgp::bench
