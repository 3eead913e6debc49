// Lifts of the diagonal of a matrix that is positive definite but for rounding.  Role: how forms with blocks retry.
#pragma once

#include "hgp/linalg/factor/factor_status.h"

namespace hgp::linalg {

/// Relative lifts, in the order in which they are tried.
inline constexpr double kLifts[] = {0.0, 1e-13, 1e-11, 1e-9};

/// Calls factor(lift) with one lift after another until its status is ok.
/// @return the last status, with its lift
template <class Factor>
FactorStatus withLifts(const Factor& factor) {
  FactorStatus status;
  for (const double lift : kLifts) {
    status = factor(lift);
    status.lift = lift;
    if (status) break;
  }
  return status;
}

}  // namespace hgp::linalg
