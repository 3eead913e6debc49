#include "hgp/base/float32.h"

#include <cmath>

namespace hgp {

double roundToFloat(double x) {
  // From half an ulp above the largest float on, rounding gives infinity; a cast out of range is undefined.
  constexpr double kTooLarge = 0x1.ffffffp127;
  if (x >= kTooLarge) return HUGE_VAL;
  if (x <= -kTooLarge) return -HUGE_VAL;
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

}  // namespace hgp
