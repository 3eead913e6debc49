// Harmonic rows and parts of triangles on a cut along which a cone has moved.  Role: terms of the programs of a drag.
#pragma once

#include "hgp/mesh/geometry.h"
#include "hgp/parametrize/live/moved_cut.h"

namespace hgp::live {

/// The row of (14) at an interior vertex, Σw = 1, in the chart of mesh.outgoing(v).
Terms harmonicRow(const TriMesh& mesh, const Geometry& geometry, const MovedCut& cut, VertexId v);

/// f_z and f_z̄ of a triangle.
struct FaceTerms {
  Terms similar, anti;
};
FaceTerms faceTerms(const Geometry& geometry, const MovedCut& cut, FaceId f);

/// A sum of squares over few unknowns: ½ δᴴ H δ + Re(cᴴ δ).
struct SumOfSquares {
  explicit SumOfSquares(std::size_t count);
  /// Adds weight² |Σ factor δ[index(unknown)] + constant|²; terms with a negative index are left out.
  /// @param index  by unknown
  void add(const Terms& terms, const std::vector<int>& index, const Complex& constant,
           double weight2);

  Eigen::MatrixXcd H;
  Eigen::VectorXcd c;
};

/// Weight of relative changes of a triangle: one over the square of its margin (|f_z| − |f_z̄|) / |f_z|, at most 10⁴. The
/// nearer it is to a fold, the less it may change.
double stiffness(const Complex& fz, const Complex& fzbar);

}  // namespace hgp::live
