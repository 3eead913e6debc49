// What the programs of a drag are made of at one position of the cone.
#pragma once

#include <vector>

#include "hgp/parametrize/live/frame_rows.h"
#include "hgp/parametrize/live/moved_field.h"

namespace hgp::live {

/// A position of the cone, and what both programs of DragDisc need of it.
struct DiscFrame {
  const MovedCut& cut;
  const MovedField& field;
  VertexId to;
  Eigen::VectorXcd start;  ///< x*, numbered as `cut` does
  /// Linear term of the soft triangles out of reach, by number of the root.
  Eigen::VectorXcd far;
  Eigen::VectorXcd reduced;  ///< the same with everything but the disc eliminated
};

/// A soft triangle of x*.
struct SoftFace {
  FaceId face;
  double weight2 = 0.0;  ///< σ A_f e^{−2u}
  Terms similar, anti;   ///< f_z and f_z̄ over numbers of the root
  Complex fz, fzbar;     ///< of x*
};

/// Triangles around the moved cone, in one of the programs.
struct OwnFaces {
  std::vector<FaceId> faces;  ///< ascending
  double weight = 1.0;        ///< of their soft terms
};

}  // namespace hgp::live
