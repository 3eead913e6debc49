// Configures how this process obtains memory from the system.  Role: a decision of the program, not of the library;
// one call at the start of main.
#pragma once

namespace hgp::cli {

/// Makes freed memory be reused instead of being returned to the system. A run allocates and frees large blocks all
/// the time, and every new page costs a page fault and its clearing: 8 % of the time for a million triangles. Memory
/// limits do not change.
void keepFreedMemory();

}  // namespace hgp::cli
