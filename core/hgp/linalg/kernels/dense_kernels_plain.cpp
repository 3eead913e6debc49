// Dense kernels in ISO C++: two doubles in a struct, in the same order as the baseline's, so that the numbers
// are the same. For compilers without vector extensions; elsewhere only tests run them.
#include "hgp/linalg/kernels/dense_kernels.h"

#if !defined(__EMSCRIPTEN__) || defined(HGP_PORTABLE)
#ifndef HGP_PORTABLE
#define HGP_PORTABLE  // for the body below
#endif

namespace hgp::linalg {
namespace {

struct V {
  double lane[2];
};
constexpr int kWidth = 2, kTileVectors = 2, kTileCols = 4;
inline V operator+(V a, V b) { return {{a.lane[0] + b.lane[0], a.lane[1] + b.lane[1]}}; }
inline V operator-(V a, V b) { return {{a.lane[0] - b.lane[0], a.lane[1] - b.lane[1]}}; }
inline V operator*(V a, V b) { return {{a.lane[0] * b.lane[0], a.lane[1] * b.lane[1]}}; }
inline V operator-(double a, V b) { return {{a - b.lane[0], a - b.lane[1]}}; }
inline V multiplyAdd(V a, V b, V c) { return a * b + c; }
inline V swapPairs(V a) { return {{a.lane[1], a.lane[0]}}; }
inline V pairSigns() { return {{1.0, -1.0}}; }

}  // namespace
}  // namespace hgp::linalg

#include "hgp/linalg/kernels/dense_kernels_impl.h"

namespace hgp::linalg {

const KernelTable* plainKernels() {
  static const KernelTable table = {"ISO C++",          update<false>,     update<true>,
                                    factorPanel<false>, factorPanel<true>, factorPanelLu};
  return &table;
}

}  // namespace hgp::linalg
#else
namespace hgp::linalg {
const KernelTable* plainKernels() { return nullptr; }
}  // namespace hgp::linalg
#endif
