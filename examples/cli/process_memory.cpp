#include "process_memory.h"

#include <cstdlib>  // also defines macros that identify the C library

// Sanitizers have a malloc of their own, which marks every byte of a block.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HGP_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HGP_SANITIZED
#endif
#endif
#if defined(__GLIBC__) && !defined(HGP_PORTABLE) && !defined(HGP_SANITIZED)
#define HGP_GLIBC_HEAP
#endif

#ifdef HGP_GLIBC_HEAP
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#endif

namespace hgp::cli {

#ifdef HGP_GLIBC_HEAP
namespace {

/// Makes the heap so large, in addresses alone, and asks the kernel for pages of 2 MB there. False if it cannot be.
bool reserveInLargePages(std::size_t bytes, std::size_t page) {
  void* const reserved = std::malloc(bytes);
  if (reserved == nullptr) return false;
  void* begin = reserved;
  std::size_t left = bytes;
  if (std::align(page, page, begin, left) != nullptr)
    madvise(begin, left / page * page, MADV_HUGEPAGE);  // a wish; failing changes nothing
  std::free(reserved);
  return true;
}

}  // namespace
#endif

void keepFreedMemory() {
#ifdef HGP_GLIBC_HEAP
  // All memory comes from one heap that does not shrink, for all threads; if it cannot grow, malloc falls back to mmap.
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);
  mallopt(M_TOP_PAD, 8 << 20);
  constexpr std::size_t kMaxReserved = std::size_t{1} << 33, kMinReserved = std::size_t{1} << 26;
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const auto pages = static_cast<std::size_t>(std::max(0L, sysconf(_SC_PHYS_PAGES)));
  for (std::size_t bytes = std::min(pages / 2 * page, kMaxReserved); bytes >= kMinReserved;
       bytes /= 2)
    if (reserveInLargePages(bytes, page)) break;
#endif
}

}  // namespace hgp::cli
