// How this process asks the system for memory.  Role: a program's choice, not the library's; one call
// at the start of main.
#pragma once

namespace hgp::cli {

/// Memory that was freed is used again instead of being returned to the system and fetched anew. A
/// run allocates and frees large blocks all the time, and every fresh page costs a fault and a
/// clearing: 8 % of a run of a million triangles. No limit changes.
void keepFreedMemory();

}  // namespace hgp::cli
