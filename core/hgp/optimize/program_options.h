// Options of one program.  Role: the choices between the program as printed in [BCW17] and its variants.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <variant>
#include <vector>

#include "hgp/linalg/ordering/ordering.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// The whole surface: every unknown but the one that is held (pinnedUnknown).
struct WholeSurface {};
/// A part of a map that is solved again while everything else is held.
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
  /// vertexTree(mesh, 2), if it is known; used for the whole surface only.
  const linalg::SeparatorTree* wideTree = nullptr;
  /// Of the whole surface, without frame conditions: the harmonic map of least distortion instead (nearestHarmonic).
  bool isHarmonic = false;
};

/// Exactly harmonic away from frame conditions (see exactForm); always of the whole surface.
struct ExactObjective {
  /// @param tree  of the mesh's vertices (vertexTree); lives as long as the objective
  explicit ExactObjective(const linalg::SeparatorTree& tree) : vertexTree(&tree) {}
  const linalg::SeparatorTree* vertexTree;
};

class HarmonicBasis;
/// Harmonic at every vertex off cones and boundary; of these maps, the one with the least distortion of all faces.
struct HarmonicObjective {
  std::shared_ptr<const HarmonicBasis> basis;  ///< null: the program has no solution
};

using Objective = std::variant<PenaltyObjective, ExactObjective, HarmonicObjective>;

/// Soft frame constraints: instead of a condition (13), the distortion term of these faces has this weight. A program
/// without hard ones is one linear system.
struct SoftFrames {
  std::vector<FaceId> faces;
  double weight = 0.0;
};

struct ProgramOptions {
  /// log conformal factor: rows are weighted by e^{−u}, and frame conditions are in units of e^u;
  /// u = 0 is the program as printed.
  PerVertex<double> u;
  /// ε of (13) in units of the local scale e^u. The printed program is homogeneous, so that ε matters only
  /// relative to a term that fixes the scale.
  double margin = 0.05;
  /// δ of a distortion term that only makes the minimiser unique: a disk with a free boundary, a flat torus and
  /// others have whole spaces of q-CCMs. It selects the most conformal of them.
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
