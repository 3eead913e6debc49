#include "hgp/parametrize/along/index_search.h"

#include <algorithm>
#include <set>

#include "hgp/base/stable_order.h"
#include "hgp/features/index_flow.h"
#include "hgp/features/step_repair.h"
#include "hgp/mesh/face_rings.h"
#include "hgp/optimize/feature_lengths.h"
#include "hgp/parametrize/along/straight_run.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

constexpr int kMaxMoves = 24;
/// Short edges whose corners are moved, and moves per corner and direction.
constexpr std::size_t kShortEdges = 24, kMovesPerNode = 6;
/// Fields that are tried, times triangles; at least and at most so many.
constexpr double kTrials = 4e5;
constexpr int kFewestTrials = 24, kMaxTrials = 400, kMaxMaps = 120;
/// A move must lower the excess to this share.
constexpr double kProgress = 0.97;
/// Larger surfaces have too few trials for maps.
constexpr int kLargestForMaps = 8000;
/// Maps with more wrong triangles and angles are not mended by kMaxMoves moves.
constexpr double kMaxWrong = 100.0;
/// Excess of a field whose lengths are impossible, beside wrong triangles of others.
constexpr double kImpossibleLengths = 1e6;

/// How far a field is from the goal.
struct Score {
  double excess = 0.0;
  bool isReached = false;
  LengthFit fit;
  std::vector<FaceId> wrong;  ///< of a map
};

class Search {
 public:
  Search(PreparedSurface& surface, const StraightSetup& setup, IndexGoal goal,
         const ParametrizeOptions& options)
      : surface_(surface),
        goal_(goal),
        features_(setup.seamless.field.spec.features),
        options_(options),
        field_(setup.aligned) {
    const double trials = kTrials / std::max(1, surface.mesh().faceCount());
    const int most = goal == IndexGoal::kMap ? kMaxMaps : kMaxTrials;
    left_ = std::clamp(static_cast<int>(trials), kFewestTrials, most);
    StraightSetup start = setup;
    score_ = scoreOf(start);
  }

  IndexSearch run() {
    IndexSearch out;
    if (score_.isReached) return out;
    const bool isFarOff = score_.excess > kMaxWrong && score_.fit.isPossible;
    if (goal_ == IndexGoal::kMap && isFarOff) return out;
    while (out.moves < kMaxMoves && !score_.isReached && step()) ++out.moves;
    out.isCancelled = isCancelled_;
    if (!score_.isReached || isCancelled_) return out;
    out.field = std::move(field_);
    return out;
  }

 private:
  /// Of a setup that is completed if its map is asked for.
  Score scoreOf(StraightSetup& setup) const {
    Score score;
    const SeamlessSystem system = systemOf(surface_.mesh(), setup.seamless);
    score.fit = fitLengths(straightSystemOf(setup, system));
    score.excess = score.fit.excess;
    score.isReached = score.fit.isPossible;
    if (goal_ == IndexGoal::kLengths) return score;
    score.isReached = false;
    score.excess += kImpossibleLengths;
    if (!score.fit.isPossible) return score;
    completeStraight(surface_.mesh(), setup);
    std::vector<Round> rounds;
    StraightAttempt attempt =
        StraightRun(surface_.mesh(), setup, options_, rounds).solveWithoutFrames();
    score.isReached = attempt.certificate.isCertified;
    score.excess = attempt.wrongCount;
    score.wrong = std::move(attempt.wrong);
    return score;
  }

  /// Corners and cones around what is wrong, and what is wrong there.
  void addWrong(std::set<int>& nodes) const {
    const TriMesh& mesh = surface_.mesh();
    for (FaceId f : growFaces(mesh, score_.wrong, 2))
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        const int node = field_.sectors.node(mesh, h);
        if (field_.index[at(node)] != (field_.sectors.of[h] < 0 ? 4 : 2)) nodes.insert(node);
      }
  }

  /// The corners at which runs through short edges end, and those of flat triangles.
  std::set<int> corners() const {
    const TriMesh& mesh = surface_.mesh();
    const LengthFit& fit = score_.fit;
    std::set<int> nodes;
    for (std::size_t i = 0; i < fit.edges.size() && i < kShortEdges; ++i)
      for (const HalfedgeId h : {fit.edges[i], mesh.twin(fit.edges[i])}) {
        if (!h.isValid()) continue;
        const std::vector<HalfedgeId> run = straightRun(mesh, field_, h);
        nodes.insert(field_.sectors.node(mesh, run.front()));
        nodes.insert(field_.sectors.node(mesh, TriMesh::next(run.back())));
      }
    for (std::size_t i = 0; i < fit.flat.size() && i < kShortEdges; ++i)
      for (int k = 0; k < 3; ++k)
        nodes.insert(field_.sectors.node(mesh, TriMesh::halfedge(fit.flat[i], k)));
    addWrong(nodes);
    return nodes;
  }

  std::vector<IndexMove> candidates() {
    const Geometry& geometry = surface_.context().geometry;
    std::vector<IndexMove> moves;
    for (const int node : corners())
      for (const int sign : {1, -1})
        for (IndexMove& move :
             cheapestMoves(surface_.mesh(), geometry, field_, node, sign, kMovesPerNode))
          moves.push_back(std::move(move));
    sortStably(moves, [](const IndexMove& a, const IndexMove& b) { return a.cost < b.cost; });
    return moves;
  }

  /// Takes the move that reaches the goal, or that which comes nearest to it.
  bool step() {
    std::optional<AlignedField> best;
    Score bestScore;
    bestScore.excess = kProgress * score_.excess;
    for (const IndexMove& move : candidates()) {
      if (left_-- <= 0) break;
      if (!report(options_.progress, {Stage::kSolve, 0.0})) {
        isCancelled_ = true;
        return false;
      }
      AlignedField next = field_;
      applyMove(surface_.mesh(), move, next);
      std::vector<StageTime> times;
      Result<StraightSetup> setup = prepareLengths(surface_, features_, next, {}, times);
      if (!setup) continue;
      Score score = scoreOf(*setup);
      if (!score.isReached && score.excess >= bestScore.excess) continue;
      best = std::move(setup->aligned);
      bestScore = std::move(score);
      if (bestScore.isReached) break;
    }
    if (!best) return false;
    field_ = std::move(*best);
    score_ = std::move(bestScore);
    return true;
  }

  PreparedSurface& surface_;
  const IndexGoal goal_;
  const std::vector<EdgeId> features_;
  const ParametrizeOptions& options_;
  AlignedField field_;
  Score score_;
  int left_ = 0;
  bool isCancelled_ = false;
};

}  // namespace

IndexSearch searchIndices(PreparedSurface& surface, const StraightSetup& setup, IndexGoal goal,
                          const ParametrizeOptions& options) {
  if (goal == IndexGoal::kMap && surface.mesh().faceCount() > kLargestForMaps) return {};
  return Search(surface, setup, goal, options).run();
}

}  // namespace hgp
