// The outcome of a factorization.  Role: not an error: callers add to the diagonal, repair or give up.
#pragma once

namespace hgp::linalg {

/// Converts to true if the factor can be used; it then has only finite entries.
struct FactorStatus {
  bool ok = true;
  int badPivot = -1;  ///< unknown at which the pivot was not positive enough, −1 when ok
  double lift = 0.0;  ///< relative diagonal lift that was needed (0 nearly always)

  explicit operator bool() const { return ok; }
};

/// A pivot must exceed `kPivotTolerance` times the matrix's own diagonal entry at its place. This
/// is invariant under diagonal scaling, as Cholesky itself is, so uneven row weights do no harm.
inline constexpr double kPivotTolerance = 1e-14;

}  // namespace hgp::linalg
