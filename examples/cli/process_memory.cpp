#include "process_memory.h"

#include <cstdlib>  // also defines macros that identify the C library

#if defined(__GLIBC__) && !defined(HGP_PORTABLE)
#include <malloc.h>

#include <climits>
#endif

namespace hgp::cli {

void keepFreedMemory() {
#if defined(__GLIBC__) && !defined(HGP_PORTABLE)
  // All memory comes from one heap that does not shrink, for all threads; if it cannot grow, malloc falls back to mmap.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_TOP_PAD, 8 << 20);
#endif
}

}  // namespace hgp::cli
