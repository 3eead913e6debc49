// Given cones, a certified locally injective seamless map.  Role: the page that reads like §7 of
// [BCW17]; the only loop over "try, judge, repair".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/base/progress.h"
#include "hgp/base/result.h"
#include "hgp/mesh/field_data.h"
#include "hgp/mesh/holonomy_spec.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/parametrize/method.h"
#include "hgp/verify/certificate.h"

namespace hgp {

struct ParametrizeOptions {
  int maxRounds = 24;  ///< programs at most
  Method method = Method::kAuto;
  bool useQuality = false;  ///< add the distortion term: lower μ, no longer harmonic
  /// Directions (and matchings, where stored) to take as the frames d_j of (13) and as seam
  /// rotations, instead of our own smooth connection with the same holonomy. They must realise the
  /// prescription exactly, and decide what it leaves open.
  std::optional<FieldData> frames;
  Progress progress;  ///< return false to cancel
};

/// One pass of "solve, judge, repair".
struct Round {
  std::string method;            ///< what was tried, in words ("weighted", "growth", "lift", …)
  int constrainedTriangles = 0;  ///< |F_cb| and what growth added
  int iterations = 0;            ///< of the interior-point method
  std::string solverStatus;      ///< "optimal", "infeasible", "stalled", …
  int flipped = 0;               ///< triangles that are not positive
  int wrongAngles = 0;           ///< vertices and loops with a wrong angle sum
  double laplacianEnergy = 0.0;  ///< ‖Lz‖², a solver statistic
  double seconds = 0.0;
};

/// Seconds per stage, in the order run.
struct StageTime {
  std::string stage;
  double seconds = 0.0;
};

struct Parametrization {
  UvMap map;                     ///< one uv per copy of a vertex in the cut mesh S_c
  std::vector<VertexId> copyOf;  ///< uv index → vertex of S ("xref")
  CompleteSpec spec;             ///< what was asked, completed
  Certificate certificate;       ///< of `map`, by inspection
  bool isCertified = false;
  bool isUsable = false;    ///< its areas fit double precision; certified maps are
  std::vector<Round> rounds;
  std::vector<StageTime> times;
  std::vector<std::string> notes;  ///< warnings and explanations for people
  std::vector<FaceId> conflict;    ///< triangles that fight, where the program is infeasible
};

/// Solves and judges one connected surface. A map that is not certified is a successful return with
/// isCertified = false; failures are prescriptions that cannot be, given frames that contradict the
/// prescription (kPrescription) or are none (kUsage, kMalformed), limits and cancellation.
/// The road depends on mesh, prescription and options alone.
/// @pre mesh has one component
Result<Parametrization> parametrize(const TriMesh& mesh, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// Tutte/Floater: a disk onto a convex polygon (regular, vertices by arc length) with mean-value
/// weights. Fails with kUnsupported when the surface is not a disk, with kUsage for given frames.
Result<Parametrization> parametrizeConvex(const TriMesh& mesh, const ParametrizeOptions& options);

/// Cones, turning and handles of a smooth field of order q ("automatic cones").
struct SuggestOptions {
  int q = 4;
  int coneCount = 0;              ///< roughly how many; 0 = as the field has them after clean-up
  bool alignToCurvature = false;  ///< follow principal curvature instead of smoothness alone
  Progress progress;
};
Result<CompleteSpec> suggestCones(const TriMesh& mesh, const SuggestOptions& options);

/// Both again for a surface that is kept: what one run prepared, the next ones use. What was suggested
/// and is then solved gives the map of the same cones named by anybody else, to the last bit.
class PreparedSurface;
Result<CompleteSpec> suggestCones(PreparedSurface& surface, const SuggestOptions& options,
                                  std::vector<StageTime>* times = nullptr);
Result<Parametrization> parametrize(PreparedSurface& surface, const HolonomySpec& spec,
                                    const ParametrizeOptions& options);

/// The prescription that a given field has, exactly (stored matchings are the truth). `expected`: cones
/// that came along; refused when the matchings contradict them.
Result<CompleteSpec> readHolonomy(const TriMesh& mesh, const FieldData& field,
                                  const std::vector<ConePoint>& expected = {});

}  // namespace hgp
