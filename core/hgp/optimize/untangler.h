// The descent of untangle() over triangles whose f_z and f_z̄ are given.  Role: the same for complex unknowns and for real
// ones, which are parts of complex numbers.
#pragma once

#include <array>
#include <vector>

#include "hgp/optimize/untangle.h"

namespace hgp {

/// f_z and f_z̄ of a triangle, in its own units and in its frame, over real parts [0] and imaginary parts [1] of unknowns:
///   f_z = Σ similar[0] Re x + similar[1] Im x + heldSimilar.
struct UntangleFace {
  struct Term {
    int unknown;
    std::array<Complex, 2> similar, anti;
  };
  std::vector<Term> terms;  ///< not empty
  Complex heldSimilar, heldAnti;
  bool isKept = false;                    ///< UntangleOptions::kept
  std::array<int, 3> beside{-1, -1, -1};  ///< neighbours by number, −1: none

  /// Multiplies f_z and f_z̄.
  void scale(const Complex& similarFactor, double antiFactor);
};

/// The triangles of a mesh that have unknowns.
class UntangleFaces {
 public:
  UntangleFaces(const TriMesh& mesh, const UntangleOptions& options);

  /// Takes f_z and f_z̄ as they are, into units of e^{u_f} and the frame.
  void add(FaceId f, UntangleFace face, double frameAngle);
  std::vector<UntangleFace> take();

 private:
  const TriMesh& mesh_;
  const UntangleOptions& options_;
  PerFace<char> isKept_;
  std::vector<UntangleFace> faces_;
  std::vector<FaceId> faceOf_;
};

/// @param start  `count` unknowns, as UntangleResult::x then; a part that no triangle has stays as it is
UntangleResult untangleFaces(std::vector<UntangleFace> faces, int count,
                             const Eigen::VectorXcd& start, const UntangleOptions& options);

}  // namespace hgp
