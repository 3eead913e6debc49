// How the trivial connection changes when one cone moves.  Role: frames and conformal factor of a drag, without
// computing the whole field again.
#pragma once

#include "hgp/field/field_context.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/parametrize/live/moved_cut.h"

namespace hgp::live {

/// Differences from the field of the map where the drag began. With the curvature κ = 2π(1 − k/q) moved from one node to
/// another, L Δu = κ (δ_to − δ_from), and frames turn by Δω = w dΔu + w Σ c_i ξ_i across edges, where c makes the
/// transport along every generator change by that of the path's crossings. Charts are those of MovedCut.
class MovedField {
 public:
  /// @param context  with Laplacian and handles; must outlive the object, as the mesh
  MovedField(const TriMesh& mesh, const FieldContext& context);

  /// @param cone  where it was, and its index
  void move(int q, ConePoint cone, VertexId to, const MovedCut& cut);
  /// Δu alone, which needs no path.
  void moveScale(int q, ConePoint cone, VertexId to);

  double scaleAt(VertexId v) const;                     ///< Δu
  double scaleAt(FaceId f) const;                       ///< mean over the corners
  double angleAt(FaceId f) const { return angle_[f]; }  ///< of the frame; up to multiples of 2π
  /// By how much the rotation along each handle generator changes, any integer.
  const std::vector<int>& handleChange() const { return handleChange_; }

 private:
  double omega(HalfedgeId h) const;
  void correctHandles(int q, const MovedCut& cut);

  const TriMesh& mesh_;
  const FieldContext& context_;
  std::vector<HalfedgeId> tree_;  ///< from known faces to new ones, breadth first from face 0
  Eigen::VectorXd u_;             ///< by node
  PerEdge<double> harmonic_;      ///< Σ c_i ξ_i; empty without handles
  PerFace<double> angle_;
  std::vector<int> handleChange_;
};

}  // namespace hgp::live
