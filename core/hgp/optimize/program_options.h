// How one program is stated.  Role: the choices between the printed program and its variants.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// A part of a map to solve for again, everything else left where it is.
struct LocalPart {
  std::vector<char> isFree;  ///< by unknown of ReducedUnknowns
  Eigen::VectorXcd x;        ///< all unknowns; those that are not free keep these values
};

struct ProgramOptions {
  /// log conformal factor that rows and frame conditions are weighted by (recipe: scale weighting);
  /// all zero is the program as printed.
  PerVertex<double> u;
  /// ε of (13) in units of the local scale e^u. Only its size relative to a scale-fixing term
  /// counts: the printed program is homogeneous.
  double margin = 0.05;
  /// δ of the distortion term δ Σ A_f e^{−2u} (|f_z − e^u d_j|² + |f_z̄|²); 0: none.
  double quality = 0.0;
  /// The same term with a weight so small that it merely makes the minimiser unique (a disk with a
  /// free boundary, a flat torus and many others have whole spaces of q-CCMs). It prefers the most
  /// conformal of them.
  double tieBreak = 1e-5;
  /// Harmonicity exact where no frame condition reaches, instead of minimised everywhere (see
  /// exactForm). Needs `vertexTree`.
  bool isExact = false;
  const linalg::SeparatorTree* vertexTree = nullptr;
  /// Faces whose distortion term weighs `pull` instead: frame conditions that may be broken. With
  /// no other frames the program is one linear system.
  std::vector<FaceId> pulled;
  double pull = 0.0;
  /// Solve for the free unknowns only; never with `isExact`.
  const LocalPart* local = nullptr;
  std::function<bool(int, double)> progress;
};

}  // namespace hgp
