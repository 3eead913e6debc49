// The strain energy of a change of a map, a quadratic form.  Role: the objective when translations become integers,
// for the choice of the integers and for the change of the map.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "hgp/seams/seam_structure.h"
#include "hgp/system/face_rows.h"

namespace hgp {

/// The unknowns of a seamless change dx of a map with these seams: one per vertex whose closure does
/// not rotate, then one translation per chain. Cones are x = T/(1 − i^r).
class SeamlessChange {
 public:
  SeamlessChange(const TriMesh& mesh, const SeamStructure& seams);

  int count() const { return count_; }
  int vertexUnknown(VertexId v) const { return vertexUnknown_[v]; }  ///< −1 at rotating cones
  int chainUnknown(int chain) const { return count_ - chainCount_ + chain; }
  const std::vector<int>& vertexUnknowns() const { return vertexUnknown_.raw(); }

  struct Term {
    int unknown;
    Complex factor;
  };
  /// The change at a copy: Σ factor · unknown; appended to `out` times `scale`.
  void append(int copy, const Complex& scale, std::vector<Term>& out) const;
  /// All copies.
  std::vector<Complex> evaluate(const Eigen::VectorXcd& x) const;

 private:
  const SeamStructure& seams_;
  int count_ = 0, chainCount_ = 0;
  PerVertex<int> vertexUnknown_;
  PerVertex<int> closureOf_;
};

/// Of a triangle of the map.
LinearParts planeParts(const SeamStructure& seams, const std::vector<Vec2>& uv, FaceId f);

/// Weights of the strain energy Σ_f w_f (|dx_z̄|² + δ |dx_z|²).
struct StrainWeights {
  double similarity = 0.1;  ///< δ: smaller values preserve angles at the cost of areas
  PerFace<double> face;     ///< w_f
};
StrainWeights strainWeights(const TriMesh& mesh, const SeamStructure& seams,
                            const std::vector<Vec2>& uv);

/// The map and the form that a change is computed from; references only.
struct ChangeContext {
  const TriMesh& mesh;
  const SeamStructure& seams;
  const SeamlessChange& change;
  const std::vector<Vec2>& uv;  ///< the map that is changed
  const StrainWeights& weights;
};

/// Derivatives of the change of a face with respect to the map's own plane, over numbers of `free`: with f = z + dx,
/// f_z = 1 + dx_z and f_z̄ = dx_z̄. The other unknowns have the values that they have in x.
void strainRows(const ChangeContext& context, FaceId f, const FreeUnknowns& free,
                const Eigen::VectorXcd& x, FaceRows& rows);

/// ½ y* H y + Re(c* y) over the free unknowns y.
struct StrainForm {
  Eigen::SparseMatrix<Complex> H;
  Eigen::VectorXcd c;
};
/// The strain of these faces, with the other unknowns as in x.
StrainForm strainForm(const ChangeContext& context, const std::vector<FaceId>& faces,
                      const FreeUnknowns& free, const Eigen::VectorXcd& x);

}  // namespace hgp
