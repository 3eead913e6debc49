// Supernodal elimination front by front.  Role: the common part of the Cholesky classes of this module.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <vector>

#include "hgp/linalg/factor/factor_status.h"
#include "hgp/linalg/factor/symbolic.h"

namespace hgp::linalg {

/// A node's Schur complement onto its rows, r × r, column-major, lower triangle (the upper one is undefined).
template <class Scalar>
struct Contribution {
  std::unique_ptr<double[]> memory;  // doubles, because an array of std::complex would be zeroed
  Scalar* values() const { return reinterpret_cast<Scalar*>(memory.get()); }
};

/// The entries of the matrix in the front of node t; called by several threads at a time. `local[p]` is the row of position p in that front:
/// 0 … s − 1 for the node's own pivots, s … s + r − 1 for its rows (valid for these positions only).
template <class Scalar>
struct FrontSource {
  /// Adds entries of the pivot columns to the zeroed panel, (s + r) × s.
  std::function<void(int t, const int* local, Scalar* panel, int rows)> addToPanel;
  /// Adds entries below and right of the pivots to the r × r complement; may be empty.
  std::function<void(int t, const int* local, Scalar* panel, Scalar* complement)> addToComplement;
  /// By node, the complements of children of another class, which stay; null if there are none.
  const std::vector<Contribution<Scalar>>* below = nullptr;
};

/// The panels [L11; L21] of the nodes of one class.
template <class Scalar>
class PanelFactor {
 public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// @param nodeClass  eliminate only nodes of this class (0 or 1); −1: all
  void layOut(std::shared_ptr<const SymbolicFactor> symbolic, int nodeClass = -1);

  /// Eliminates in order; a child's complement is freed when its parent has taken it. Complements of
  /// nodes whose parent is of another class stay in `left` (by node), which may be null if there are
  /// none.
  /// @param diagonal  by position: the matrix's own diagonal, which pivots are compared with
  /// @return badPivot is a *position*; on failure the panels are freed
  FactorStatus eliminate(const FrontSource<Scalar>& source, const std::vector<double>& diagonal,
                         std::vector<Contribution<Scalar>>* left);

  /// x := L⁻¹ x on the nodes of the class, rows beyond updated; x by position, any columns.
  void forward(Eigen::Ref<Matrix> x) const;
  /// x := L⁻ᴴ x on the nodes of the class, given the rows beyond.
  void backward(Eigen::Ref<Matrix> x) const;

  bool isReady() const { return ready_; }
  bool includes(int t) const { return class_ < 0 || symbolic_->dynamicNode[t] == class_; }

 private:
  Scalar* panel(int t) const { return reinterpret_cast<Scalar*>(panels_.get()) + start_[t]; }
  struct Scratch;  // of one thread
  int eliminateNode(int t, const FrontSource<Scalar>& source, const std::vector<double>& diagonal,
                    std::vector<Contribution<Scalar>>& held, Scratch& scratch);
  void extendAdd(int child, const Contribution<Scalar>& from, const int* local, int pivots,
                 Scalar* panelTo, int panelRows, Scalar* complementTo, int rows);

  std::shared_ptr<const SymbolicFactor> symbolic_;
  int class_ = -1;
  std::vector<std::size_t> start_;
  std::vector<std::vector<int>> children_, others_;  ///< of the class, and of another
  std::unique_ptr<double[]> panels_;
  bool ready_ = false;
};

extern template class PanelFactor<double>;
extern template class PanelFactor<std::complex<double>>;

}  // namespace hgp::linalg
