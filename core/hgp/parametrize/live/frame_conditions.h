// Frame conditions on a few triangles of a map that changes.  Role: what keeps triangles of a drag positive where least squares
// reverse them.
#pragma once

#include "hgp/linalg/factor/factor.h"
#include "hgp/parametrize/live/frame_rows.h"
#include "hgp/socp/problem.h"

namespace hgp::live {

/// Conditions of [BCW17 (13)] on a map x + δ, over numbered unknowns of δ; the others are held.
class FrameConditions {
 public:
  /// @param index  by unknown: its number, negative where it is held. The references must outlive the object.
  FrameConditions(const Geometry& geometry, const MovedCut& cut, const std::vector<int>& index)
      : geometry_(geometry), cut_(cut), index_(index) {}

  /// Re(f_z d̄) / |d| − |f_z̄| ≥ ε |d| on this triangle, d = target: what it would be of a similarity. A triangle without a
  /// number is left out.
  void add(FaceId f, const Complex& target, const Eigen::VectorXcd& x);

  /// The minimiser of ½ δᴴHδ + Re(cᴴδ) under these conditions; empty where none was found.
  Eigen::VectorXcd minimise(const SumOfSquares& sum) const;

 private:
  const Geometry& geometry_;
  const MovedCut& cut_;
  const std::vector<int>& index_;
  std::vector<socp::ConeConstraint> constraints_;
  linalg::Cliques cliques_;
};

}  // namespace hgp::live
