// Configures how this process obtains memory from the system.  Role: a decision of the program, not of the library;
// one call at the start of main.
#pragma once

namespace hgp::cli {

/// Makes freed memory be reused instead of being returned to the system, and asks for pages of 2 MB where the system has
/// them (Linux with glibc). A run allocates and frees large blocks all the time, and every new page costs a page fault and
/// its clearing: of pages of 4 KB, a fifth of the time for 100 000 triangles (docs/decisions/102). Memory limits do not
/// change; what is reserved are addresses, of which those in use count as memory.
void keepFreedMemory();

}  // namespace hgp::cli
