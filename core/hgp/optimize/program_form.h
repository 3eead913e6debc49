// A program reduced to the unknowns that its frame conditions touch.  Role: two ways to get there,
// one interface for the cone program.
#pragma once

#include <memory>

#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/program_terms.h"

namespace hgp {

/// minimise ½ xᴴ H x + Re(cᴴ x) over the form's unknowns.
class ProgramForm {
 public:
  virtual ~ProgramForm() = default;

  /// Number of an unknown (of ReducedUnknowns, not a held one) in `cholesky`.
  virtual int place(int unknown) const = 0;
  /// All unknowns of ReducedUnknowns from those of the form.
  virtual Eigen::VectorXcd expand(const Eigen::VectorXcd& x) const = 0;

  linalg::PartialCholesky cholesky;
  Eigen::VectorXcd c;
};

/// (11) as printed: harmonic residuals and the distortion term of all faces are minimised.
/// Null when the form is singular.
std::unique_ptr<ProgramForm> penaltyForm(const ProgramInput& in, const PenaltyObjective& objective,
                                         const HeldUnknowns& held);

/// Harmonicity exact at every vertex that no frame condition touches; what is minimised is the
/// residual at the touched ones. Half the factor's size and a fraction of its cost, for maps that
/// have harmonic neighbours: automatic cones and disks. Its root is dense.
/// Null when rows are singular, or more than kLargestExactRoot unknowns are touched.
std::unique_ptr<ProgramForm> exactForm(const ProgramInput& in, const ExactObjective& objective,
                                       const HeldUnknowns& held);
inline constexpr int kLargestExactRoot = 1200;

}  // namespace hgp
