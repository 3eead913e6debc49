// How a factorization ended.  Role: an outcome, not an error: callers lift, repair or give up.
#pragma once

namespace hgp::linalg {

/// True in a condition when the factor can be used. Nothing non-finite is ever left in a factor
/// that is reported good.
struct FactorStatus {
  bool ok = true;
  int badPivot = -1;  ///< unknown at which the pivot was not positive enough, −1 when ok
  double lift = 0.0;  ///< relative diagonal lift that was needed (0 nearly always)

  explicit operator bool() const { return ok; }
};

/// A pivot is refused when it is not above `kPivotTolerance` × the matrix's own diagonal entry there:
/// invariant under diagonal scaling, as Cholesky itself is, so uneven row weights do no harm.
inline constexpr double kPivotTolerance = 1e-14;

}  // namespace hgp::linalg
