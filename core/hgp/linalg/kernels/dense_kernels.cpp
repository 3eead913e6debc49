#include "hgp/linalg/kernels/dense_kernels.h"

#include <atomic>

namespace hgp::linalg {
namespace {

std::atomic<bool> isBaselineAsked{false};

}  // namespace

int runnableKernels(const KernelTable* tables[kMaxTables]) {
  int count = 0;
  if (plainKernels() && plainKernels() != baselineKernels()) tables[count++] = plainKernels();
  tables[count++] = baselineKernels();
#if (defined(__x86_64__) || defined(__i386__)) && !defined(HGP_NO_DISPATCH) && \
    !defined(HGP_PORTABLE)
  const bool fused = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  if (avx2Kernels() && fused) tables[count++] = avx2Kernels();
  if (avx512Kernels() && fused && __builtin_cpu_supports("avx512f"))
    tables[count++] = avx512Kernels();
#endif
  return count;
}

const KernelTable& kernels() {
  static const KernelTable* const best = [] {
    const KernelTable* tables[kMaxTables];
    return tables[runnableKernels(tables) - 1];
  }();
  return isBaselineAsked.load(std::memory_order_relaxed) ? *baselineKernels() : *best;
}

void useBaselineKernels(bool isAsked) { isBaselineAsked = isAsked; }
bool areBaselineKernelsUsed() { return isBaselineAsked; }

}  // namespace hgp::linalg
