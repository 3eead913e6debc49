#include "least_squares_conformal.h"

#include <Eigen/SparseCholesky>

namespace hgp::bench {

Eigen::VectorXcd leastSquaresConformal(const FaceTerms& terms) {
  // f_z̄ is complex linear in the unknowns, so that the normal equations are Hermitian.
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(6 * at(terms.faceCount()));
  Eigen::VectorXcd rhs = Eigen::VectorXcd::Zero(terms.freeCount());
  for (int f = 0; f < terms.faceCount(); ++f)
    for (const FaceTerms::Term& row : terms.terms(f)) {
      const Complex left = terms.weight(f) * std::conj(row.anti);
      rhs[row.unknown] -= left * terms.heldAnti(f);
      for (const FaceTerms::Term& column : terms.terms(f))
        if (row.unknown >= column.unknown)
          entries.emplace_back(row.unknown, column.unknown, left * column.anti);
    }
  Eigen::SparseMatrix<Complex> normal(terms.freeCount(), terms.freeCount());
  normal.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver(normal);
  if (solver.info() != Eigen::Success) return {};
  return solver.solve(rhs);
}

}  // namespace hgp::bench
