// The descent of untangle() over triangles whose f_z and f_z̄ are given.  Role: the same for complex unknowns and for real
// ones, which are parts of complex numbers.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "hgp/optimize/program.h"

namespace hgp {

struct UntangleOptions {
  PerVertex<double> u;  ///< log scale that triangles are measured in, as in ProgramOptions
  /// Triangles that, once positive, stay positive at every step: those around cones and along the
  /// boundary, whose angle sums then keep their multiple of 2π.
  std::vector<FaceId> kept;
  /// λ: keeps triangles from shrinking to nothing; large, it asks for equal scale.
  double scaleWeight = 0.05;
  double epsilonShare = 0.2;  ///< ε over the most negative D
  int maxIterations = 100;    ///< Newton steps without frames
  /// Called before every step with its number and the share of triangles still flipped; false cancels.
  std::function<bool(int, double)> progress;
};

struct UntangleResult {
  Eigen::VectorXcd x;  ///< the unknowns
  int iterations = 0;
  int flipped = 0;  ///< triangles whose scaled Jacobian is not positive
  bool isCancelled = false;
};

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
