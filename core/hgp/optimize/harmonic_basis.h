// All maps that are harmonic at every vertex off cones and boundary.  Role: the hypothesis of Theorem 6.1 as a linear
// parametrization: programs over it have few unknowns and exactly harmonic maps.
#pragma once

#include <memory>
#include <vector>

#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/program_options.h"
#include "hgp/system/seamless_system.h"

namespace hgp {

/// The unknowns without a harmonic row (cones, boundary vertices, translations) are free, but for one that is held at 0
/// because a translation of the whole map is free. All others follow from the rows of [BCW17 (7), (8), (14)], which are
/// eliminated once: x = extend(y).
///
/// A flat torus, which has no cone, has two: its translations. One vertex is held, whose row follows from the others where
/// weights are symmetric, as cotangents are. With others the sum of all rows, with positive factors, is a real equation
/// between the translations, and every harmonic map collapses the torus to a line.
class HarmonicBasis {
 public:
  /// @param u     log scale: where the map is smallest, its unknown is held
  /// @param tree  of the mesh's vertices (vertexTree)
  /// Null where the rows are singular, and on a flat torus with weights that are not symmetric.
  static std::shared_ptr<const HarmonicBasis> make(const SeamlessSystem& system,
                                                   const PerVertex<double>& u,
                                                   const linalg::SeparatorTree& tree);

  /// Number of unknowns y of a basis, before it is made.
  static int countOf(const SeamlessSystem& system);
  int count() const { return static_cast<int>(free_.size()); }  ///< of y
  /// All unknowns from y.
  Eigen::VectorXcd expand(const Eigen::VectorXcd& y) const;
  /// Some unknowns from y: x = B y, |unknowns| × count(). Not to be called by two threads.
  Eigen::MatrixXcd rowsOf(const std::vector<int>& unknowns) const;
  /// The distortion term of all faces (distortionRows, δ = 1) in terms of y.
  const linalg::QuadraticForm& distortion() const { return distortion_; }
  double multiplyAdds() const { return multiplyAdds_; }  ///< of the elimination and the distortion

 private:
  Eigen::MatrixXcd keptOf(const Eigen::MatrixXcd& y) const;
  bool fulfilsRowOf(int unknown) const;
  void restrictDistortion(const SeamlessSystem& system, const PerVertex<double>& u);

  std::vector<int> kept_;  // unknowns without a row, ascending
  std::vector<int> free_;  // y, as indices into kept_: all but the one that is held
  linalg::SchurLu lu_;
  std::unique_ptr<linalg::SchurExtension> rows_;  // of rowsOf()
  linalg::QuadraticForm distortion_;
  double multiplyAdds_ = 0.0;
};

}  // namespace hgp
