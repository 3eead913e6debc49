#include "hgp/base/float32.h"

#include <cmath>

namespace hgp {

double roundToFloat(double x) {
  // Half an ulp above the largest float is where rounding goes to infinity; a cast may not.
  constexpr double kTooLarge = 0x1.ffffffp127;
  if (x >= kTooLarge) return HUGE_VAL;
  if (x <= -kTooLarge) return -HUGE_VAL;
  const volatile float rounded = static_cast<float>(x);
  return static_cast<double>(rounded);
}

}  // namespace hgp
