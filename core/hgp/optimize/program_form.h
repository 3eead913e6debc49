// A program reduced to the unknowns that occur in its frame conditions.  Role: one interface for the two ways
// of reducing it, penaltyForm and exactForm.
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
  virtual int number(int unknown) const = 0;
  /// Rows over unknowns of ReducedUnknowns become rows over the form's.
  virtual void rewrite(FaceRows& rows) const {
    for (FaceRows::Term& term : rows.terms) term.unknown = number(term.unknown);
  }
  /// All frame conditions contain all unknowns, in their order.
  virtual bool isDense() const { return false; }
  /// All unknowns of ReducedUnknowns from those of the form.
  virtual Eigen::VectorXcd expand(const Eigen::VectorXcd& x) const = 0;

  /// All unknowns of ReducedUnknowns from the solution of the reduced problem.
  Eigen::VectorXcd translate(const Eigen::VectorXd& reduced) const {
    return expand(cholesky.extend(reduced, c));
  }

  linalg::PartialCholesky cholesky;
  Eigen::VectorXcd c;
};

/// (11) as printed: harmonic residuals and the distortion term of all faces are minimised.
/// Null when the form is singular.
std::unique_ptr<ProgramForm> penaltyForm(const ProgramInput& in, const PenaltyObjective& objective,
                                         const HeldUnknowns& held);

/// The map is exactly harmonic at every vertex that occurs in no frame condition; the residual at the others is
/// minimised. Half the factor size of penaltyForm and a fraction of its cost, for maps that are close to
/// harmonic: automatic cones and disks. The root of the factor is dense.
/// Null when the rows are singular, or frame conditions contain more than kLargestExactRoot unknowns.
std::unique_ptr<ProgramForm> exactForm(const ProgramInput& in, const ExactObjective& objective,
                                       const HeldUnknowns& held);
inline constexpr int kLargestExactRoot = 1200;

/// Harmonic at every vertex that is neither cone nor boundary: the program over objective.basis.
/// Null when there is no basis, or the soft faces do not determine the map.
std::unique_ptr<ProgramForm> harmonicForm(const ProgramInput& in,
                                          const HarmonicObjective& objective);

}  // namespace hgp
