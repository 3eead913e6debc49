// Real unknowns as pairs.  Role: lets improve(), which works over complex unknowns, descend with features held straight.
#pragma once

#include "hgp/features/real_unknowns.h"
#include "hgp/system/reduced_unknowns.h"

namespace hgp {

/// Real unknown i is the real or imaginary part of complex unknown variable[i]/2, with which it stays together; parts that
/// are determined by others occur nowhere. Where it is held, it is a part of a pair of its own, all of which is held.
class RealPairs {
 public:
  /// @param unknowns  of the seams alone, of which `real` has parts
  /// @param isHeld    by real unknown; empty: none
  RealPairs(const TriMesh& mesh, const CutMesh& cut, const ReducedUnknowns& unknowns,
            const RealUnknowns& real, const std::vector<char>& isHeld);

  /// Copies over the pairs and their conjugates (see ReducedMap): Re x = (x + x̄)/2, Im x = (x − x̄)/2i. Pairs that occur only at
  /// one vertex are its unknown.
  const ReducedUnknowns& unknowns() const { return pairs_; }
  /// By column of copies.
  const std::vector<char>& isHeld() const { return isHeld_; }
  /// With the conjugates.
  Eigen::VectorXcd pairsOf(const Eigen::VectorXd& values) const;

  /// Which part of the pairs a real unknown is (see partsOf).
  const std::vector<int>& parts() const { return parts_; }

 private:
  std::vector<int> parts_;
  ReducedUnknowns pairs_;
  std::vector<char> isHeld_;
};

}  // namespace hgp
