// The convex program of a map whose features are straight.  Role: [BCW17 (11)–(13)] over real unknowns, with one
// linear inequality per feature edge instead of frames along features.
#pragma once

#include "hgp/features/real_unknowns.h"
#include "hgp/features/sum_relations.h"
#include "hgp/optimize/program.h"
#include "hgp/optimize/real_tree.h"

namespace hgp {

/// The map sends halfedge h, in the chart of its face, to a positive multiple of i^heading.
struct StraightEdge {
  HalfedgeId h;
  int heading = 0;  ///< 0 … 3
};

/// The distance of a cone from the line of a side of its patch (lone_cones.h).
struct SideDistance {
  RealSum sum;  ///< positive in every map
  HalfedgeId side;
  double length = 1.0;  ///< half that of the whole side on the surface
};

/// References only; the objects must outlive it.
struct StraightSystem {
  const SeamlessSystem& system;
  const RealUnknowns& unknowns;            ///< of system.unknowns.copies and the edges' equations
  const std::vector<StraightEdge>& edges;  ///< one side of every feature edge
  const std::vector<SideDistance>& distances;  ///< of cones that are alone in their patches
  const PerVertex<char>& hasRow;  ///< harmonic: inner vertices off features that are no cones
  RealTree& tree;                 ///< of these unknowns and rows
};

struct StraightOptions {
  PerVertex<double> u;  ///< as ProgramOptions::u
  double margin =
      0.05;  ///< ε of (13), and of a feature edge relative to its length in the metric e^u
  double quality = 1e-4;  ///< δ of the distortion term
  /// Values of unknowns that are given, such as integers of a grid; the others are solved for.
  std::vector<std::pair<int, double>> given;
  std::function<bool(int, double)> progress;
};

struct StraightResult {
  Eigen::VectorXd x;
  std::vector<Complex> z;  ///< per copy
  socp::SolveStatus status = socp::SolveStatus::kStalled;
  int iterations = 0;
  double multiplyAdds = 0.0;
  double laplacianEnergy = 0.0;
  std::vector<FaceId> conflict;  ///< with the largest duals, if infeasible: of frames and of edges
  std::vector<HalfedgeId> conflictEdges;  ///< of these, the feature edges
};

/// Without given values, the translation of the whole map is fixed where it is smallest.
/// minimise ‖D L z‖² + δ Σ A e^{−2u} (|f_z − e^u d|² + |f_z̄|²), L the rows of hasRow, subject to
///   (13) on the faces of `frames`,   Re(i^{−heading} (z_head − z_tail)) ≥ ε e^u ℓ on every edge,  ℓ its length,
///   and every distance of a cone from a side ≥ ε e^u ℓ/2,  ℓ the length of the side.
StraightResult solveStraight(const StraightSystem& straight, const Frames& frames,
                             const StraightOptions& options);

/// The covariance of unknowns in the objective alone, (H⁻¹) restricted to `variables`; translations of the whole map are
/// nearly free. Empty where H cannot be factored.
Eigen::MatrixXd straightCovariance(const StraightSystem& straight, const StraightOptions& options,
                                   const std::vector<int>& variables);

}  // namespace hgp
