// Dense kernels for two doubles at a time: plain x86-64, WebAssembly SIMD, NEON.
#include "hgp/linalg/kernels/dense_kernels.h"

#if defined(__GNUC__) && !defined(HGP_PORTABLE)

namespace hgp::linalg {
namespace {

typedef double V __attribute__((vector_size(16)));
constexpr int kWidth = 2, kTileVectors = 2, kTileCols = 4;
inline V multiplyAdd(V a, V b, V c) { return a * b + c; }
inline V swapPairs(V a) { return V{a[1], a[0]}; }
inline V pairSigns() { return V{1.0, -1.0}; }

}  // namespace
}  // namespace hgp::linalg

#include "hgp/linalg/kernels/dense_kernels_impl.h"

namespace hgp::linalg {

const KernelTable* baselineKernels() {
  static const KernelTable table = {"two doubles",      update<false>,     update<true>,
                                    factorPanel<false>, factorPanel<true>, factorPanelLu};
  return &table;
}

}  // namespace hgp::linalg
#else
namespace hgp::linalg {
const KernelTable* baselineKernels() { return plainKernels(); }
}  // namespace hgp::linalg
#endif
