// What to try next when a map is not certified.  Role: the loop of [BCW17 §7], ordered by what
// helps most often (docs/decisions): weights of the cone metric, growth, clamped weights, new scale.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/optimize/program.h"
#include "hgp/parametrize/seamless_setup.h"

namespace hgp {

/// Ranges of log scale (max u − min u) above which success gets rare, and use impossible.
inline constexpr double kHardScaleRange = 15.0;
inline constexpr double kHopelessScaleRange = 25.0;

struct RepairStep {
  std::string method;
  PerVertex<double> u;
  Frames frames;
  double quality = 0.0;
  bool isExact = false;
  std::vector<FaceId> pulled;  ///< see ProgramOptions
  double pull = 0.0;
  std::optional<LocalPart> local;  ///< only this part is solved for again
};

/// A ladder of weightings; on each, the constrained set grows around what is wrong (where frames
/// pull, only a patch around that is solved for again: the rest is harmonic already). Before that, two
/// things are mended where they occur: cones whose triangles fight get frames from their own embedded
/// ring, and cones whose ring is positive but whose angle is off by a multiple of 2π are fixed (§7.1).
class RepairPlan {
 public:
  RepairPlan(const TriMesh& mesh, const SeamlessSetup& setup, bool useQuality);

  /// The next program to solve, or nothing when every idea is used up.
  std::optional<RepairStep> next();
  /// What the last program gave.
  void learn(const ProgramResult& program, const Certificate& certificate);

 private:
  struct Rung {
    const char* name;
    double clamp;  ///< bound on |u − median|
    double quality;
    int growthRounds;
    bool isFromMap;  ///< u from log|f_z| of the last map
    bool isExact = false;
    double pull = 0.0;  ///< > 0: frames pull instead of bind; only what went wrong is bound
  };
  void startRung();
  int touchedUnknowns(const std::vector<FaceId>& faces) const;
  PerVertex<double> weightsOf(const Rung& rung) const;
  PerVertex<double> scaleOfMap() const;
  std::vector<FaceId> wrongFaces(const Certificate& certificate) const;
  LocalPart partOf(const std::vector<FaceId>& patch) const;
  bool isTouched(FaceId f, const LocalPart& part) const;
  /// Empty when it would be a large part of the mesh, or there is nothing to hold the rest at.
  std::vector<FaceId> smallPatchAround(const std::vector<FaceId>& faces) const;

  const TriMesh& mesh_;
  const SeamlessSetup& setup_;
  std::vector<Rung> rungs_;
  std::size_t rung_ = 0;
  int growth_ = 0;
  /// Cones next to triangles that fight get frames from their own embedded ring; true when new.
  bool embedConflictingRings(const std::vector<FaceId>& conflict);

  /// Cones with a positive ring and a wrong angle: back to the connection's own lift or, where that
  /// was used already, a local embedding of the last map; true when something was changed.
  bool fixLifts(const Certificate& certificate);

  std::vector<FaceId> base_, faces_;
  std::vector<FaceId> pulled_;         ///< base_, and a ring around it where that costs little
  std::vector<FaceId> patch_;          ///< what the next program solves for; empty: everything
  std::vector<ConePoint> ringCones_;   ///< frames from the surface's embedded ring
  std::vector<ConePoint> fixedCones_;  ///< frames from the last map's embedded ring
  PerVertex<double> u_;
  std::vector<Complex> lastMap_;
  Eigen::VectorXcd lastUnknowns_;
  std::vector<FaceId> wrong_;  ///< of that map
  std::size_t wrongCount_ = 0;
  int patchRings_ = 0;
};

}  // namespace hgp
