// The programs of one field along features.  Role: attempts with other weights and larger constrained sets until the
// verifier accepts the map.
#pragma once

#include <optional>

#include "hgp/parametrize/along/given_values.h"
#include "hgp/verify/verdict.h"

namespace hgp {

struct StraightAttempt {
  StraightResult program;
  UvMap map;
  Certificate certificate;
  std::vector<FaceId> wrong;  ///< not positive, or at a vertex or loop with a wrong angle
  int wrongCount = 0;
  double untangled = 0.0;  ///< Newton steps × triangles of untangling that led here
};

/// Unknowns on a grid.
struct GridValues {
  double scale = 1.0;        ///< cells per unit of the map as solved
  GivenValues given;         ///< in cells
  PerFace<double> angle;     ///< frames of the map as solved, as Frames::angles
  double untanglings = 0.0;  ///< Newton steps × triangles that may be spent
};

class StraightRun {
 public:
  /// @param grid  null: without one. Its maps are in cells, and lengths that contradict each other are not looked for.
  StraightRun(const TriMesh& mesh, const StraightSetup& setup, const ParametrizeOptions& options,
              std::vector<Round>& rounds, const GridValues* grid = nullptr)
      : mesh_(mesh),
        setup_(setup),
        options_(options),
        rounds_(rounds),
        grid_(grid),
        verifier_(mesh) {}

  /// The first certified map of a program; where none is, the one that is nearest to it, untangled if that helps.
  /// Nothing if it was cancelled.
  std::optional<StraightAttempt> run();

  /// The map of the first program without frames.
  StraightAttempt solveWithoutFrames();

  /// Edges whose lengths alone contradict each other, with frames left out; empty where they do not. No program is solved
  /// for that.
  const std::vector<HalfedgeId>& shortEdges();
  /// After run(): a program without frames has no point either, as its duals show. Only then are the edges named to users.
  bool isContradictionShown() const { return isShown_; }

 private:
  struct Weighting;

  void solvePrograms();
  bool isOver(const Weighting& weighting, std::vector<FaceId> hard);
  void untangleBest();
  bool showContradiction(const Weighting& weighting);
  StraightOptions optionsOf(const Weighting& weighting);
  StraightAttempt solve(const Weighting& weighting, int growth, const std::vector<FaceId>& hard);
  bool isHopeless(const std::vector<FaceId>& wrong) const;
  void takeFrames(const StraightAttempt& attempt);
  void measure(StraightAttempt& attempt) const;
  void record(const Weighting& weighting, int growth, std::size_t hardCount,
              const StraightAttempt& attempt, double seconds);

  const TriMesh& mesh_;
  const StraightSetup& setup_;
  const ParametrizeOptions& options_;
  std::vector<Round>& rounds_;
  const GridValues* grid_;
  Verifier verifier_;
  /// On a grid: frames of the map without any, and at its triangles that are not positive those of the map as solved, turned as
  /// their neighbours are. Empty: those of the map as solved.
  PerFace<double> frames_;
  std::optional<StraightAttempt> best_;
  std::optional<std::vector<HalfedgeId>> short_;
  bool isStrained_ = false;  ///< some program had no point, although lengths are possible
  bool isShown_ = false;     ///< see isContradictionShown
  bool isCancelled_ = false;
};

}  // namespace hgp
