#include "plain_math.h"

#include <cstdlib>  // also says which C library this is
#include <string>

#if defined(__GLIBC__) && defined(__x86_64__) && !defined(HGP_PORTABLE)
#define HGP_CAN_RESTART
#include <unistd.h>
#endif

namespace hgp::cli {

bool restartWithPlainMath(char** words) {
#ifdef HGP_CAN_RESTART
  const char* const name = "GLIBC_TUNABLES";
  // Both spellings: before and since glibc 2.33.
  const std::string plain =
      "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX,-AVX512F,-AVX2_Usable,-FMA_Usable,-FMA4_Usable,"
      "-AVX_Usable";
  const char* set = std::getenv(name);
  const std::string before = set == nullptr ? "" : set;
  if (before.find(plain) != std::string::npos) return true;
  setenv(name, (before.empty() ? plain : before + ":" + plain).c_str(), 1);
  execv("/proc/self/exe", words);
  return false;
#else
  (void)words;
  return false;
#endif
}

}  // namespace hgp::cli
