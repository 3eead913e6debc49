// The work of a factorization that is partly repeated.  Role: bounds in operations rather than seconds,
// which are the same on every machine.
#pragma once

#include "hgp/linalg/factor/partial_cholesky.h"

namespace hgp::linalg {

/// Real multiply-adds of the static part once and the dynamic part `factorizations` times.
inline double multiplyAdds(const PartialCholesky::Report& report, int factorizations) {
  return 4.0 * report.staticCost.multiplyAdds + factorizations * report.dynamicCost.multiplyAdds;
}

}  // namespace hgp::linalg
