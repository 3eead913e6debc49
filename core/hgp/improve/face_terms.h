// f_z and f_z̄ of every triangle over the unknowns of a seamless map.  Role: energies as functions of the reduced
// unknowns, all values of which satisfy seams and cones.
#pragma once

#include <span>
#include <vector>

#include "hgp/mesh/geometry.h"
#include "hgp/system/face_rows.h"
#include "hgp/system/reduced_unknowns.h"

namespace hgp {

/// The data that give a vector x of reduced unknowns its meaning as a map; references must outlive their users.
/// unknowns.copies has a column per unknown or, where copies do not depend on unknowns complex-linearly, as many again for
/// their conjugates: z = copies · (x, x̄). There, vectors of unknowns have their conjugates after them, too.
struct ReducedMap {
  const TriMesh& mesh;
  const Geometry& geometry;
  const CutMesh& cut;
  const ReducedUnknowns& unknowns;
};

/// f_z = Σ similar_i x_i + heldSimilar, f_z̄ = Σ anti_i x_i + heldAnti per triangle, over the unknowns
/// that are free. Triangles without a free unknown are kept: their energy counts, their rows are empty.
class FaceTerms {
 public:
  using Term = FaceRows::Term;  ///< its unknown: the number among the free ones

  /// @param isHeld  by column of ReducedUnknowns::copies, as x; held ones stay as in x
  FaceTerms(const ReducedMap& map, const std::vector<char>& isHeld, const Eigen::VectorXcd& x);

  int faceCount() const { return static_cast<int>(weight_.size()); }
  int freeCount() const { return free_.count(); }
  /// Which columns of ReducedUnknowns::copies are free; unknowns come first, their conjugates in the same order after them.
  const FreeUnknowns& free() const { return free_; }

  std::span<const Term> terms(int face) const {
    return {terms_.data() + start_[at(face)], start_[at(face) + 1] - start_[at(face)]};
  }
  /// The triangle's fraction of the total surface area.
  double weight(int face) const { return weight_[at(face)]; }
  Complex heldSimilar(int face) const { return held_[at(face)][0]; }
  Complex heldAnti(int face) const { return held_[at(face)][1]; }

 private:
  std::vector<std::size_t> start_;
  std::vector<Term> terms_;
  std::vector<double> weight_;
  std::vector<std::array<Complex, 2>> held_;
  FreeUnknowns free_;
};

/// f_z and f_z̄ of every triangle.
struct FaceParts {
  std::vector<Complex> similar, anti;
};
/// At the free unknowns y; with `isChange`, of a change of them (what is held contributes nothing).
void evaluateParts(const FaceTerms& terms, const Eigen::VectorXcd& y, bool isChange,
                   FaceParts& parts);

/// The largest step in [0, limit] along `change` such that no triangle degenerates before it: the
/// smallest positive root of |p + αdp|² = |m + αdm|² over all triangles (Smith and Schaefer 2015).
double stepToDegeneracy(const FaceParts& parts, const FaceParts& change, double limit);

}  // namespace hgp
