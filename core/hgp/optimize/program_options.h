// How one program is stated.  Role: the choices between the printed program and its variants.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <variant>
#include <vector>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// The whole surface: every unknown but the one that is held (pinnedUnknown).
struct WholeSurface {};
/// A part of a map to solve for again, everything else left where it is.
struct Patch {
  std::vector<char> isFree;  ///< by unknown of ReducedUnknowns
  Eigen::VectorXcd x;        ///< all unknowns; those that are not free keep these values
};
/// What a program is solved for.
using Domain = std::variant<WholeSurface, Patch>;

/// Harmonicity minimised everywhere, with a distortion term:
///   ‖D L z‖² + δ Σ A_f e^{−2u} (|f_z − e^u d_j|² + |f_z̄|²).
struct PenaltyObjective {
  double quality = 0.0;  ///< δ; 0: the tie-break alone
  Domain domain;
};

/// Harmonicity exact where no frame condition reaches (see exactForm); of the whole surface always.
struct ExactObjective {
  /// @param tree  of the mesh's vertices (vertexTree); lives as long as the objective
  explicit ExactObjective(const linalg::SeparatorTree& tree) : vertexTree(&tree) {}
  const linalg::SeparatorTree* vertexTree;
};

using Objective = std::variant<PenaltyObjective, ExactObjective>;

/// Frame conditions that may be broken: the distortion term of these faces has this weight instead. With
/// no other frames the program is one linear system.
struct SoftFrames {
  std::vector<FaceId> faces;
  double weight = 0.0;
};

struct ProgramOptions {
  /// log conformal factor that rows and frame conditions are weighted by (recipe: scale weighting);
  /// all zero is the program as printed.
  PerVertex<double> u;
  /// ε of (13) in units of the local scale e^u. Only its size relative to a scale-fixing term
  /// counts: the printed program is homogeneous.
  double margin = 0.05;
  /// δ of a distortion term so small that it merely makes the minimiser unique (a disk with a
  /// free boundary, a flat torus and many others have whole spaces of q-CCMs). It prefers the most
  /// conformal of them.
  double tieBreak = 1e-5;
  Objective objective;
  SoftFrames soft;
  std::function<bool(int, double)> progress;

  /// The part that is solved for again; null for the whole surface.
  const Patch* patch() const {
    const auto* penalty = std::get_if<PenaltyObjective>(&objective);
    return penalty ? std::get_if<Patch>(&penalty->domain) : nullptr;
  }
};

}  // namespace hgp
