// The linear program of a drag, reduced to the disc in which one cone may move.  Role: what a drag factors once, so that a
// frame costs a dense factor of the disc's size and a back-substitution.
#pragma once

#include <memory>
#include <vector>

#include "hgp/linalg/factor/factor.h"
#include "hgp/parametrize/live/disc_terms.h"
#include "hgp/parametrize/live/frame_conditions.h"
#include "hgp/parametrize/live/moved_field.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp::live {

/// From a seamless map x* and a cone that has moved, the map x* + δ that minimises
///
///   Σ e^{−2u} |(L x)_v|²  at the corners of soft triangles
///   + σ Σ A_f e^{−2u} (|f_z − target|² + |f_z̄ − target|²)  over soft triangles: around cones and along boundaries,
///
/// with (L x)_v = 0 at all other vertices of the disc, and (L δ)_v = 0 at all others outside. Targets near the moved cone
/// are a similarity along its frames, as in a first round; elsewhere they are the parts of x*, turned and scaled by the
/// change of the field, so that a map that has not moved is x*, however it was found. Weights are those of x*.
///
/// Around a cone of a large angle such a map may be reversed, or turn too seldom. The second program has hard frame conditions
/// on the triangles around the moved cone instead of their soft terms, and all rows of the disc have the same weight:
/// residuals that must be somewhere are then spread over the disc.
class DragDisc {
 public:
  /// Null if the system is singular.
  /// @param setup  of the map; outlives the object, as the mesh
  /// @param x      the map's unknowns
  static std::unique_ptr<DragDisc> make(const TriMesh& mesh, const SeamlessSetup& setup,
                                        VertexId cone, Eigen::VectorXcd x);

  /// Edges from the cone to v in the disc, around other cones; empty if there are none.
  std::vector<HalfedgeId> pathTo(VertexId v) const;
  /// The positions of the cone in the disc with fewer edges to v than the cone has now; nearest first.
  std::vector<VertexId> towards(VertexId v) const;
  /// The similarity along the frames that a triangle has as a target near the cone.
  Complex targetAt(const MovedField& field, FaceId f) const;
  /// Vertices with a harmonic row while the cone is at `to`.
  bool hasRow(VertexId v, VertexId to) const { return !isFixed(v) && v != to; }
  /// The arguments outlive the frame. @pre the cone has moved
  DiscFrame frameAt(const MovedCut& cut, const MovedField& field, VertexId to) const;
  /// The changes of the disc's unknowns; empty if the system is singular.
  Eigen::VectorXcd solve(const DiscFrame& frame) const;
  /// The same by the second program; empty, too, where its conditions have no solution.
  Eigen::VectorXcd solveFramed(const DiscFrame& frame) const;
  /// All unknowns, those outside the disc as they were: enough for the triangles of facesInside().
  Eigen::VectorXcd changedInside(const DiscFrame& frame, const Eigen::VectorXcd& change) const;
  /// All unknowns.
  Eigen::VectorXcd changed(const DiscFrame& frame, const Eigen::VectorXcd& change) const;
  const Eigen::VectorXcd& start() const { return x_; }  ///< x*
  const std::vector<FaceId>& facesInside() const { return inside_; }

  /// The largest ring on which a cone or its path may be.
  int reach() const { return rings_ - 2; }
  int unknownCount() const { return static_cast<int>(disc_.size()); }
  int rootSize() const { return static_cast<int>(kept_.size()); }

 private:
  DragDisc(const TriMesh& mesh, const SeamlessSetup& setup, VertexId cone, Eigen::VectorXcd x);
  bool build();
  void chooseFaces();
  void chooseDisc();
  void chooseKept();
  void holdOne();
  SparseRows outerRows() const;
  bool readFaces();
  double scaleAt(FaceId f) const;
  bool buildDense();
  bool buildSparse();
  bool factor(const Eigen::SparseMatrix<Complex>& H, const linalg::SeparatorTree& tree);
  SoftFace softFace(FaceId f) const;
  Eigen::VectorXcd startOf(const MovedCut& cut) const;
  std::vector<FaceId> facesNear(VertexId v) const;
  bool isFixed(VertexId v) const { return isFixed_[v] != 0; }
  double rowWeight(VertexId v, bool isSoft) const;
  void addRows(const DiscFrame& frame, const std::vector<VertexId>& soft, SumOfSquares& sum) const;
  void addFaces(const DiscFrame& frame, const OwnFaces& own, SumOfSquares& sum) const;
  /// The sum with everything else eliminated.
  void addOutside(const DiscFrame& frame, SumOfSquares& sum) const;
  int rootIndex(Eigen::Index inDisc) const;
  Complex gaugeOf(const MovedField& field) const;
  Complex changeAt(const MovedField& field, FaceId f) const;

  const TriMesh& mesh_;
  const SeamlessSetup& setup_;
  VertexId cone_;
  int rings_;  ///< of the disc
  Eigen::VectorXcd x_;
  MovedCut still_;                   ///< nothing moved
  bool isGrown_ = false;             ///< soft triangles include a ring around those at cones
  PerVertex<char> isFixed_;          ///< other cones and boundaries
  PerVertex<char> isSoft_;           ///< corner of a soft triangle that is there whatever moves
  PerVertex<int> ring_;              ///< edges from the cone, up to rings_; −1 outside
  std::vector<VertexId> near_;       ///< the disc, ring by ring
  std::vector<FaceId> far_, close_;  ///< soft triangles of other cones: out of reach, within reach
  std::vector<FaceId> inside_;       ///< triangles around the disc's vertices but the last ring
  std::vector<SoftFace> farFaces_;
  Complex scale_ = 1.0;                   ///< the similarity of x* relative to u and frames
  std::vector<int> disc_, kept_, index_;  ///< unknowns; index_: in the root, −1
  std::vector<int> discAt_;               ///< unknown → index into disc_, −1
  int held_ = -1;
  bool isSparse_ = false;  ///< the root has all unknowns, and lu_ is not used
  linalg::SchurLu lu_;
  linalg::PartialCholesky root_;
  Eigen::MatrixXcd outside_;  ///< of the disc's unknowns, with everything else eliminated
};

}  // namespace hgp::live
