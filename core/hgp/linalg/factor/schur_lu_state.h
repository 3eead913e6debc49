// The factor of SchurLu.  Role: shared by the files that implement it.
#pragma once

#include "hgp/linalg/factor/schur_lu.h"
#include "hgp/linalg/kernels/kernel_workspace.h"

namespace hgp::linalg {

using SparseRows = SchurLu::SparseRows;
using SparseColumns = Eigen::SparseMatrix<std::complex<double>>;

inline std::unique_ptr<double[]> allocateComplex(std::size_t complexNumbers) {
  return std::unique_ptr<double[]>(new double[2 * complexNumbers]);  // not zeroed
}

/// One front: pivot columns of A and of Aᴴ side by side, and the full square complement.
struct Front {
  int s, r;
  std::vector<std::complex<double>> L;
  std::complex<double>* U;
  std::unique_ptr<double[]> complement;
};

/// What one thread needs to eliminate fronts.
struct FrontScratch {
  explicit FrontScratch(std::size_t unknowns) : local(unknowns) {}
  KernelWorkspace work;
  std::vector<int> local;  ///< position → row of the front
  std::vector<double> threshold;
};

struct SchurLu::State {
  SymbolicFactor symbolic;
  std::vector<int> kept;
  std::vector<int> keptAt;              // position → index in kept, −1
  std::vector<std::size_t> panelStart;  // of eliminated nodes; Uᴴ panels, (s + r) × s
  std::unique_ptr<double[]> panels;
  Eigen::MatrixXcd schur;
  std::vector<std::unique_ptr<double[]>> held;  // complements that their parents have not taken

  const std::complex<double>* complement(int t) const {
    return reinterpret_cast<const std::complex<double>*>(held[t].get());
  }
  std::complex<double>* panel(int t) const {
    return reinterpret_cast<std::complex<double>*>(panels.get()) + panelStart[t];
  }
  void layOut();
  FactorStatus eliminate(const SparseRows& A, const SparseColumns& columns);
  int eliminateNode(int t, const SparseRows& A, const SparseColumns& columns,
                    const std::vector<int>& children, FrontScratch& scratch);
  void addToSchur(int t, const std::complex<double>* complement);
  void fillPanels(int t, const SparseRows& A, const SparseColumns& columns,
                  const std::vector<int>& local, Front* front,
                  std::vector<double>* threshold) const;
};

}  // namespace hgp::linalg
