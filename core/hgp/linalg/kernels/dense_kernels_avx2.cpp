// Dense kernels for AVX2 with fused multiply-add; compiled with -mavx2 -mfma, empty without.
#include "hgp/linalg/kernels/dense_kernels.h"

#if defined(__AVX2__) && defined(__FMA__) && defined(__GNUC__) && !defined(HGP_PORTABLE)
#include <immintrin.h>

namespace hgp::linalg {
namespace {

typedef double V __attribute__((vector_size(32)));
constexpr int kWidth = 4, kTileVectors = 3, kTileCols = 4;
inline V multiplyAdd(V a, V b, V c) { return _mm256_fmadd_pd(a, b, c); }
inline V swapPairs(V a) { return _mm256_permute_pd(a, 0x5); }
inline V pairSigns() { return V{1.0, -1.0, 1.0, -1.0}; }

}  // namespace
}  // namespace hgp::linalg

#include "hgp/linalg/kernels/dense_kernels_impl.h"

namespace hgp::linalg {

const KernelTable* avx2Kernels() {
  static const KernelTable table = {
      "AVX2", update<false>, update<true>, factorPanel<false>, factorPanel<true>, factorPanelLu};
  return &table;
}

}  // namespace hgp::linalg
#else
namespace hgp::linalg {
const KernelTable* avx2Kernels() { return nullptr; }
}  // namespace hgp::linalg
#endif
