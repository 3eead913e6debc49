// Options and result of a run.  Role: the types of parametrize.h, for code that only passes them on.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/cones/choose_cones.h"
#include "hgp/grid/grid_options.h"
#include "hgp/improve/improve_options.h"
#include "hgp/mesh/field_data.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/reflection.h"
#include "hgp/parametrize/method.h"
#include "hgp/verify/certificate.h"

namespace hgp {

struct ParametrizeOptions {
  int maxRounds =
      24;  ///< maximum number of programs, with each choice of the handles that are left open
  /// No further program once so many steps are spent per triangle of the surface, or per kSmallSurface triangles where
  /// it has fewer (faceStepsOf in strategy/state.h).
  double maxStepsPerFace = 1000.0;
  static constexpr int kSmallSurface = 20'000;
  Method method = Method::kAuto;
  /// Directions (and matchings, if stored) to use as the frames d_j of (13) and as seam
  /// rotations, instead of our trivial connection with the same holonomy. They must realise the
  /// prescription exactly, and they determine what it leaves open.
  std::optional<FieldData> frames;
  /// The cones were chosen, not prescribed: where no map has them, but one without folds has others, these are taken.
  bool areConesFree = false;
  GridOptions grid;  ///< align translations to a grid after a certified solve (q = 2, 4)
  /// Lower this kind of distortion of a certified map; the result is again certified.
  std::optional<ImproveOptions> improve;
  Progress progress;  ///< return false to cancel
};

/// One pass of "solve, verify, repair".
struct Round {
  std::string method;            ///< what was tried, in words (nameOf in strategy/state.h)
  int constrainedTriangles = 0;  ///< triangles with hard frame constraints
  int iterations = 0;            ///< of the interior-point method
  std::string solverStatus;      ///< "optimal", "infeasible", "no-progress", …
  int flipped = 0;               ///< triangles that are not positive
  int wrongAngles = 0;           ///< vertices and loops with a wrong angle sum
  double laplacianEnergy = 0.0;  ///< ‖Lz‖² of (11), in uv units squared
  double multiplyAdds = 0.0;     ///< of the program's factorizations
  double seconds = 0.0;
};

/// Seconds per stage, in the order run.
struct StageTime {
  Stage stage = Stage::kPrepare;
  double seconds = 0.0;
};

/// The result of one descent.
struct DescentFacts {
  DistortionFacts before, after;  ///< as the verifier measures them; equal when it was not kept
  std::vector<ImproveStep> steps;
  DescentOutcome outcome = DescentOutcome::kNothingToGain;
  bool isKept = false;  ///< the improved map is used
  double multiplyAdds = 0.0;
};

/// The result of an improvement: the descent from the map as solved, and a second one after alignment, with the
/// integers held.
struct ImprovementFacts : DescentFacts {
  ImproveOptions asked;
  std::optional<DescentFacts> onGrid;  ///< where the map was aligned and has seams
};

struct Parametrization {
  UvMap map;                     ///< one uv per copy of a vertex in the cut mesh S_c
  std::vector<VertexId> copyOf;  ///< uv index → vertex of S ("xref")
  CompleteSpec spec;             ///< what was asked, completed
  Certificate certificate;       ///< of `map`, by inspection
  bool isCertified = false;
  bool isUsable = false;      ///< double precision resolves its areas; true of certified maps
  bool isImpossible = false;  ///< proven: no locally injective map on this mesh has these angles
  std::vector<Round> rounds;
  std::optional<ImprovementFacts> improvement;  ///< where one was asked for and the map certified
  std::vector<StageTime> times;
  Notes notes;                     ///< warnings and explanations
  std::optional<GridReport> grid;  ///< where a grid was asked; without one the map is as solved
  std::shared_ptr<const Mirror> mirror;  ///< of which the map is symmetric: u = 0 is the plane
  /// Where the best program found no point that fulfils its frames: the constrained triangles at which it was
  /// strained most. Notes say whether that the frames contradict each other is proven.
  std::vector<FaceId> strained;
};

}  // namespace hgp
