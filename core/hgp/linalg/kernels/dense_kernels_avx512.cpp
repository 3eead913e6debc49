// Dense kernels for AVX-512; compiled with -mavx512f -mfma, empty without.
#include "hgp/linalg/kernels/dense_kernels.h"

#if defined(__AVX512F__) && defined(__GNUC__) && !defined(HGP_PORTABLE)
#include <immintrin.h>

namespace hgp::linalg {
namespace {

typedef double V __attribute__((vector_size(64)));
constexpr int kWidth = 8, kTileVectors = 3, kTileCols = 8;
inline V multiplyAdd(V a, V b, V c) { return _mm512_fmadd_pd(a, b, c); }
// With a mask of all ones, because the form without a mask reads an undefined vector in GCC's headers.
inline V swapPairs(V a) { return _mm512_mask_permute_pd(a, 0xff, a, 0x55); }
inline V pairSigns() { return V{1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0}; }

}  // namespace
}  // namespace hgp::linalg

#include "hgp/linalg/kernels/dense_kernels_impl.h"

namespace hgp::linalg {

const KernelTable* avx512Kernels() {
  static const KernelTable table = {"AVX-512",          update<false>,     update<true>,
                                    factorPanel<false>, factorPanel<true>, factorPanelLu};
  return &table;
}

}  // namespace hgp::linalg
#else
namespace hgp::linalg {
const KernelTable* avx512Kernels() { return nullptr; }
}  // namespace hgp::linalg
#endif
