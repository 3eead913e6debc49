// The integers of a map and the energy of choosing them.  Role: relations over Z[i] and the strain of a
// change, reduced to the free integers.
#pragma once

#include <memory>
#include <optional>

#include "hgp/grid/cone_pairs.h"
#include "hgp/grid/grid_options.h"
#include "hgp/grid/integer_choice.h"
#include "hgp/linalg/factor/factor.h"

namespace hgp {

/// Lengths are those of the map, translated so that the cone with the smallest |1 − i^r| lies at 0 (any
/// aligned map can be translated there and stays aligned). One cell has edge length 1/scale.
class GridSystem {
 public:
  /// Empty if copies do not follow seams or the form is singular.
  static std::unique_ptr<GridSystem> make(const TriMesh& mesh, const UvMap& map, int q,
                                          const std::vector<VertexId>& cones, GridMode mode,
                                          const linalg::SeparatorTree* tree);

  int integerCount() const { return basis_.size(); }
  Eigen::VectorXcd relaxed(double scale) const { return scale * y0_; }
  /// Factors the choice for neighbours that are at most `reach` apart.
  IntegerChoice choice(double reach) const;
  ConeNeighbours neighbours(double reach) const;

  /// The change of all unknowns with minimum strain among those that give the integers y at this scale.
  Eigen::VectorXcd changeTo(const std::vector<Gaussian>& y, double scale) const;
  /// The changed map in cells, translations and, in quad mode, cones exactly integers.
  std::optional<UvMap> alignedMap(const Eigen::VectorXcd& x, double scale) const;

  /// Multiply-adds of the factorization, and of the solves of one change.
  double factorWork() const;
  double solveWork() const;

  const TriMesh& mesh() const { return mesh_; }
  const SeamStructure& seams() const { return seams_; }
  const SeamlessChange& change() const { return *change_; }
  const std::vector<Vec2>& uv() const { return uv_; }
  const StrainWeights& weights() const { return weights_; }
  /// By unknown: whether the integers determine it, as they do translations.
  const std::vector<char>& isHeld() const { return isHeld_; }

 private:
  GridSystem(const TriMesh& mesh, const UvMap& map, int q, std::vector<VertexId> cones,
             SeamStructure seams);
  bool build(GridMode mode, const linalg::SeparatorTree* tree);
  void chooseOrigin();
  bool solveIntegers(GridMode mode);
  /// Of the vertices that are not held, and then the held unknowns, as the root.
  linalg::SeparatorTree freeTree(const linalg::SeparatorTree& vertexTree) const;
  bool factor(const linalg::SeparatorTree* tree);

  const TriMesh& mesh_;
  const UvMap& map_;
  const int q_;
  const std::vector<VertexId> cones_;
  const SeamStructure seams_;
  std::unique_ptr<SeamlessChange> change_;
  std::vector<Vec2> uv_;
  StrainWeights weights_;

  GaussianSum gauge_;              ///< the sum of variables that is set to 0
  std::vector<VertexId> whole_;    ///< cones without rotation that must be integers
  std::vector<int> heldUnknowns_;  ///< chains, `whole_`, and one fixed vertex if nothing rotates
  std::vector<char> isHeld_;
  IntegerBasis basis_;
  Eigen::SparseMatrix<Complex, Eigen::RowMajor> rows_;  ///< held unknowns in terms of y
  Eigen::VectorXcd held0_, y0_;                         ///< of the map itself
  linalg::PartialCholesky cholesky_;
  std::shared_ptr<const IntegerForm> integers_;  ///< the form over y
};

}  // namespace hgp
