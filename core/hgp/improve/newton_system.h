// The quadratic model of the mean energy.  Role: assembled again in every step, but ordered and analysed once.
#pragma once

#include "hgp/improve/energy.h"
#include "hgp/improve/face_terms.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp {

/// H d = −g for H = Σ A_f Hessian(ψ_f), positive semidefinite per triangle, over the free unknowns as
/// real pairs. A general real form of complex unknowns: it is not complex Hermitian. Terms of conjugates are terms of
/// their unknowns, with the sign of the imaginary part changed.
class NewtonSystem {
 public:
  /// @param tree  of the mesh's vertices; free unknowns are ordered by it, translations appended
  NewtonSystem(const ReducedMap& map, const FaceTerms& terms, const linalg::SeparatorTree& tree);

  /// Gradient and Hessian of the mean energy of the map divided by `scale`; false when the Hessian
  /// cannot be factored.
  bool assemble(const EnergyExponents& exponents, const FaceParts& parts, double scale);

  /// The minimum of the quadratic model of the last assembly.
  struct Direction {
    Eigen::VectorXcd change;  ///< −H⁻¹ g, by free unknown; conjugates after them
    double slope;             ///< −gᵀ H⁻¹ g < 0: derivative of the mean energy along it
  };
  Direction direction() const;

  /// Multiply-adds of one assembly, factorization and direction.
  double multiplyAdds() const;

 private:
  bool isConjugate(int term) const { return term >= count_; }
  int unknownOf(int term) const { return isConjugate(term) ? term - count_ : term; }

  const FaceTerms& terms_;
  const int count_;           ///< free unknowns, without conjugates
  std::vector<int> blockOf_;  ///< clique of a face, −1 if it has no free unknown
  linalg::PartialCholesky cholesky_;
  std::vector<double> values_;
  double scale_ = 1.0;
  Eigen::VectorXcd gradient_;  ///< of the map divided by scale_, ∂/∂Re + i ∂/∂Im
};

}  // namespace hgp
