// The convex program of one round.  Role: [BCW17 (11)–(13)] → socp::Problem and back, in one file.
#pragma once

#include <functional>
#include <vector>

#include "hgp/optimize/frames.h"
#include "hgp/socp/solve.h"
#include "hgp/system/harmonic.h"

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

/// What one program returned.
struct ProgramResult {
  std::vector<Complex> z;  ///< |V_c| positions
  Eigen::VectorXcd x;      ///< the unknowns they come from
  socp::SolveStatus status = socp::SolveStatus::kStalled;
  int iterations = 0;
  double laplacianEnergy = 0.0;  ///< ‖Lz‖², rows normalised to Σw = 1
  std::vector<FaceId> conflict;  ///< constrained triangles with the largest duals, if infeasible
};

/// minimise ‖D L z‖² + distortion, over seamless z, subject to
///   Re(f_z d̄_j) − |f_z̄| ≥ ε e^{u_f} on the frames' faces [BCW17 (13)],  D = diag(e^{−u_v}).
/// With `local`, over its free unknowns alone; each frame's triangle must have one.
ProgramResult solveProgram(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                           const SeamRotations& seams, const ReducedUnknowns& unknowns,
                           const HarmonicSystem& harmonic, const Frames& frames,
                           const ProgramOptions& options);

}  // namespace hgp
