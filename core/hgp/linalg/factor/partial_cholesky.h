// A large fixed Hermitian form plus a small changing real one.  Role: the linear algebra of the cone
// program; each interior-point iteration refactors only what its second-order cones can reach.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <complex>
#include <memory>
#include <vector>

#include "hgp/linalg/factor/changing_form.h"
#include "hgp/linalg/factor/factor_status.h"
#include "hgp/linalg/factor/symbolic.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp::linalg {

struct PartialCholeskyOptions {
  /// Separator tree of the pattern of H and the cliques; null: computed here (a tree of the mesh
  /// graph with separators of width 2 is found three times faster, see DissectionOptions). Cliques
  /// need not be respected by the tree: each is moved up to where it fits.
  const SeparatorTree* tree = nullptr;
  /// Expected number of factor() calls, which determines the balance of static and dynamic work.
  int iterations = 12;
  /// Touched unknowns are moved up to ancestors of at most this depth (0: all in one dense root;
  /// a large number: all stay in place). −1: chosen by operation counts.
  int delayDepth = -1;
  /// Depths whose factors and caches would exceed this many bytes are not chosen, unless all do
  /// (then those up to 1.2 times the smallest are allowed).
  double maxBytes = 1.5e9;
};

/// Factors and solves with K = real(H) + Σ_b E_bᵀ D_b E_b, and related operations, for
///
///   minimise over x ∈ Cⁿ:  ½ xᴴ H x + Re(cᴴ x) + (convex terms in the touched unknowns)
///
/// Complex unknown j is the real pair (2j, 2j + 1) = (Re, Im) in every real vector and block. Unknowns
/// that no changing term reaches are *static*: eliminated once, in complex arithmetic. The others,
/// all touched ones among them, form the *reduced problem* of dynamicSize() complex unknowns.
/// Pivots are compared with their own diagonal entry (kPivotTolerance): scale-invariant.
class PartialCholesky : public ChangingForm {
 public:
  PartialCholesky();
  ~PartialCholesky() override;
  PartialCholesky(PartialCholesky&&) noexcept;
  PartialCholesky& operator=(PartialCholesky&&) noexcept;

  /// @param H        n × n Hermitian positive semidefinite, stored in full (both triangles)
  /// @param cliques  complex unknowns of each changing block, distinct within a block
  /// @return not ok with the unknown where H is singular on the static unknowns (nothing pins it)
  FactorStatus build(const Eigen::SparseMatrix<std::complex<double>>& H, const Cliques& cliques,
                     const PartialCholeskyOptions& options = {});

  int size() const;
  int dynamicSize() const;
  /// Index of an unknown in the reduced problem, −1 if it is static.
  int dynamicIndex(int unknown) const;

  /// c_d − H_du H_uu⁻¹ c_u: the linear term of the reduced problem (complex, dynamicSize()).
  Eigen::VectorXcd reduceLinear(const Eigen::VectorXcd& c) const;
  /// H̃ x, H̃ = H_dd − H_du H_uu⁻¹ H_ud in real form; 2·dynamicSize() → 2·dynamicSize().
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const override;
  /// H̃ as a dense complex matrix, dynamicSize() × dynamicSize(), for problems with few dynamic unknowns.
  Eigen::MatrixXcd reducedForm() const;

  /// Factors H̃ + Σ blocks, the dynamic part only. blocks[b] is symmetric positive semidefinite,
  /// 2m × 2m for a clique of m unknowns, rows in the clique's order. When a pivot is bad, retries
  /// with relative diagonal lifts (1e-13, 1e-11, 1e-9); not ok when all fail.
  FactorStatus factor(const std::vector<Eigen::MatrixXd>& blocks);
  /// The same from flat storage: block b is the column-major square at values[blockOffset(b)].
  FactorStatus factor(const double* values) override;
  std::size_t blockOffset(int b) const override;
  std::size_t blockStorage() const override;  ///< doubles in all blocks

  /// (H̃ + Σ blocks)⁻¹ B for the last good factor; 2·dynamicSize() rows.
  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const override;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& rhs) const;

  /// The full minimiser: dynamic unknowns as given, static ones −H_uu⁻¹ (c_u + H_ud x_d).
  Eigen::VectorXcd extend(const Eigen::VectorXd& xd, const Eigen::VectorXcd& c) const;

  /// What build() chose, for reports and tests.
  struct Report {
    int delayDepth = 0;
    FactorCost staticCost;   ///< complex, once
    FactorCost dynamicCost;  ///< real-equivalent (pairs counted as reals), per factor()
  };
  const Report& report() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace hgp::linalg
