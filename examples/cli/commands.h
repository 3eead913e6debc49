// The commands.  Role: arguments in, exit code out.
#pragma once

#include "arguments.h"

namespace hgp::cli {

int runCommand(const Arguments& arguments);

}  // namespace hgp::cli
