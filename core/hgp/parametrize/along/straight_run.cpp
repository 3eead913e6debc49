#include "hgp/parametrize/along/straight_run.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/mesh/face_rings.h"
#include "hgp/optimize/feature_lengths.h"
#include "hgp/optimize/untangle_straight.h"
#include "hgp/parametrize/round.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {

/// How the programs of one pass are weighted: the scale e^{share·u}, and δ.
struct StraightRun::Weighting {
  const char* name;
  double share;
  double quality;
};

namespace {

/// Enlargements of the constrained set for each of the weightings.
constexpr int kGrowthRounds = 3;
/// Lines on integers need lengths that are shorter than those of the map as solved, some of which are at their least.
constexpr double kGridMargin = 0.1;
/// Integers with which this share of the triangles is wrong are given up.
constexpr double kHopeless = 0.1;
/// Newton steps × triangles of untangling without a grid, and the steps that one may take.
constexpr double kPlainUntangling = 1.2e7;
constexpr int kLongestUntangling = 250;

void findWrong(const TriMesh& mesh, const Topology& topology, StraightAttempt& attempt) {
  const Certificate& c = attempt.certificate;
  if (!c.isMeasured) {
    attempt.wrongCount = 1 << 30;
    return;
  }
  attempt.wrong = c.orientation.notPositive;
  attempt.wrongCount = static_cast<int>(attempt.wrong.size() + c.angles.wrong.size());
  const auto addRing = [&](VertexId v) {
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) attempt.wrong.push_back(TriMesh::face(h));
  };
  for (const MeasuredCone& cone : c.angles.wrong) addRing(cone.vertex);
  for (const MeasuredTurning& turning : c.angles.turnings) {
    if (!turning.isWrong) continue;
    ++attempt.wrongCount;
    for (HalfedgeId h : topology.loops[at(turning.loop.i)].halfedges) addRing(mesh.tail(h));
  }
  std::sort(attempt.wrong.begin(), attempt.wrong.end());
  attempt.wrong.erase(std::unique(attempt.wrong.begin(), attempt.wrong.end()), attempt.wrong.end());
}

/// In cells, as solved.
UvMap plainMap(const TriMesh& mesh, const CutMesh& cut, const std::vector<Complex>& z) {
  UvMap map;
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    map.cornerUv.push_back(
        {cut.copy[h].i, cut.copy[TriMesh::next(h)].i, cut.copy[TriMesh::previous(h)].i});
  }
  for (const Complex& p : z) map.uv.push_back({p.real(), p.imag()});
  return map;
}

}  // namespace

std::optional<StraightAttempt> StraightRun::run() {
  solvePrograms();
  if (!isCancelled_ && best_ && !best_->certificate.isCertified) untangleBest();
  return isCancelled_ ? std::nullopt : std::move(best_);
}

void StraightRun::solvePrograms() {
  static constexpr Weighting kWeightings[] = {{"straight features", 1.0, 1e-4},
                                              {"straight features, even weights", 0.0, 1e-4},
                                              {"straight features, light distortion", 1.0, 1e-2}};
  for (const Weighting& weighting : kWeightings) {
    if (isOver(weighting, setup_.base)) return;
    if (grid_ && isStrained_) break;
  }
  if (!isStrained_) return;
  // Frames contradict each other, the lengths or the integers: the map without them shows where some are needed.
  static constexpr Weighting kFrameless[] = {
      {"straight features, first without frames", 1.0, 1e-4},
      {"straight features, even weights, first without frames", 0.0, 1e-4}};
  for (const Weighting& weighting : kFrameless) {
    if (isOver(weighting, {}) || grid_) return;
  }
}

/// From the best map, with the integers held: where frames contradict each other there can be a map all the same.
void StraightRun::untangleBest() {
  const auto start = std::chrono::steady_clock::now();
  const Weighting weighting{"straight features, untangled", 1.0, 0.0};
  const double most = grid_ ? grid_->untanglings : kPlainUntangling;
  const bool isLast = !grid_ && static_cast<int>(rounds_.size()) >= options_.maxRounds;
  const Eigen::VectorXd& x = best_->program.x;
  const bool hasStart = x.size() > 0 && x.allFinite() && !isShown_;
  if (isLast || !hasStart || kLongestUntangling * static_cast<double>(mesh_.faceCount()) > most)
    return;
  const SeamlessSetup& seamless = setup_.seamless;
  const SeamlessSystem system = systemOf(mesh_, seamless);
  const StraightOptions program = optionsOf(weighting);
  UntangleOptions options;
  options.u = program.u;
  options.kept = setup_.base;
  options.progress = program.progress;
  StraightUntangling result =
      untangleStraight(straightSystemOf(setup_, system), x, program.given,
                       grid_ ? grid_->angle : seamless.seams.frameAngle, options);
  if (isCancelled_) return;
  StraightAttempt attempt;
  attempt.program.x = std::move(result.x);
  attempt.program.z = std::move(result.z);
  attempt.program.iterations = result.iterations;
  if (result.flipped == 0) attempt.program.status = socp::SolveStatus::kOptimal;
  measure(attempt);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  record(weighting, 0, 0, attempt, spent.count());
  const bool isBetter = attempt.certificate.isCertified || attempt.wrongCount < best_->wrongCount;
  if (isBetter) best_ = std::move(attempt);
  best_->untangled = static_cast<double>(result.iterations) * mesh_.faceCount();
}

StraightAttempt StraightRun::solveWithoutFrames() {
  return solve({"straight features, without frames", 1.0, 1e-4}, 0, {});
}

/// Programs of one weighting, with frames on `hard` and then also around what is wrong, until one is certified or nothing more
/// is to be tried.
bool StraightRun::isOver(const Weighting& weighting, std::vector<FaceId> hard) {
  for (int growth = 0; growth <= kGrowthRounds; ++growth) {
    if (static_cast<int>(rounds_.size()) >= options_.maxRounds) return true;
    StraightAttempt attempt = solve(weighting, growth, hard);
    if (isCancelled_) return true;
    const std::vector<FaceId> wrong = attempt.wrong;
    const bool isInfeasible = socp::isWithoutPoint(attempt.program.status);
    if (grid_ && hard.empty() && !isInfeasible) takeFrames(attempt);
    if (!best_ || attempt.certificate.isCertified || attempt.wrongCount < best_->wrongCount)
      best_ = std::move(attempt);
    if (best_->certificate.isCertified) return true;
    isStrained_ = isStrained_ || isInfeasible || isHopeless(wrong);
    if (isInfeasible && growth == 0 && !shortEdges().empty() && showContradiction(weighting))
      return true;
    if (isCancelled_) return true;
    if (isInfeasible || wrong.empty() || isHopeless(wrong)) return false;
    const std::vector<FaceId> more = growFaces(mesh_, wrong, 1);
    const std::size_t before = hard.size();
    hard.insert(hard.end(), more.begin(), more.end());
    std::sort(hard.begin(), hard.end());
    hard.erase(std::unique(hard.begin(), hard.end()), hard.end());
    if (hard.size() == before) return false;
  }
  return false;
}

bool StraightRun::isHopeless(const std::vector<FaceId>& wrong) const {
  return grid_ && static_cast<double>(wrong.size()) > kHopeless * mesh_.faceCount();
}

const std::vector<HalfedgeId>& StraightRun::shortEdges() {
  if (!short_ && !grid_) {
    const SeamlessSystem system = systemOf(mesh_, setup_.seamless);
    short_ = fitLengths(straightSystemOf(setup_, system)).edges;
  }
  if (!short_) short_.emplace();
  return *short_;
}

/// Lengths that are fitted contradict each other up to a tolerance; a program without frames decides.
bool StraightRun::showContradiction(const Weighting& weighting) {
  const StraightOptions program = optionsOf(weighting);
  const SeamlessSystem system = systemOf(mesh_, setup_.seamless);
  const StraightResult result = solveStraight(straightSystemOf(setup_, system), {}, program);
  isShown_ = socp::isWithoutPoint(result.status);
  return isShown_;
}

StraightOptions StraightRun::optionsOf(const Weighting& weighting) {
  StraightOptions program;
  program.u = setup_.seamless.field.u;
  for (double& u : program.u.raw()) u *= weighting.share;
  program.quality = weighting.quality;
  if (grid_) {
    const double shift = portable::log(grid_->scale);
    for (double& u : program.u.raw()) u += shift;
    program.given = grid_->given;
    program.margin *= kGridMargin;
  }
  const int round = static_cast<int>(rounds_.size()) + 1;
  program.progress = [this, round](int iteration, double residual) {
    const double fraction = 1.0 - 1.0 / (1.0 + 0.25 * iteration);
    const ProgressReport now = grid_ ? ProgressReport{Stage::kAlign, 0.0}
                                     : ProgressReport{Stage::kSolve, fraction, iteration,
                                                      residual,      round,    options_.maxRounds};
    isCancelled_ = !report(options_.progress, now);
    return !isCancelled_;
  };
  return program;
}

StraightAttempt StraightRun::solve(const Weighting& weighting, int growth,
                                   const std::vector<FaceId>& hard) {
  const auto start = std::chrono::steady_clock::now();
  const SeamlessSetup& seamless = setup_.seamless;
  const StraightOptions program = optionsOf(weighting);
  const SeamlessSystem system = systemOf(mesh_, seamless);
  StraightAttempt attempt;
  Frames frames = fieldFrames(seamless.seams, hard);
  if (grid_)
    for (std::size_t j = 0; j < frames.faces.size(); ++j)
      frames.angles[j] = (frames_.raw().empty() ? grid_->angle : frames_)[frames.faces[j]];
  attempt.program = solveStraight(straightSystemOf(setup_, system), frames, program);
  measure(attempt);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  record(weighting, growth, hard.size(), attempt, spent.count());
  return attempt;
}

void StraightRun::measure(StraightAttempt& attempt) const {
  const SeamlessSetup& seamless = setup_.seamless;
  attempt.map = grid_ ? plainMap(mesh_, seamless.cut, attempt.program.z)
                      : layOut(mesh_, seamless, attempt.program.z);
  attempt.certificate = verifier_.certify(toSpec(seamless.field.spec), attempt.map);
  findWrong(mesh_, seamless.context->topology, attempt);
}

void StraightRun::takeFrames(const StraightAttempt& attempt) {
  const SeamlessSetup& seamless = setup_.seamless;
  frames_ = framesOfMap(seamless.context->geometry, seamless.cut, attempt.program.z);
  PerFace<char> isKnown(at(mesh_.faceCount()), 1);
  for (FaceId f : attempt.certificate.orientation.notPositive) isKnown[f] = 0;
  for (FaceId f : attempt.certificate.orientation.notPositive) {
    Complex turn = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId twin = mesh_.twin(TriMesh::halfedge(f, k));
      if (!twin.isValid() || !isKnown[TriMesh::face(twin)]) continue;
      const FaceId beside = TriMesh::face(twin);
      turn += portable::polar(1.0, frames_[beside] - grid_->angle[beside]);
    }
    frames_[f] = grid_->angle[f] + (turn != 0.0 ? portable::arg(turn) : 0.0);
  }
}

void StraightRun::record(const Weighting& weighting, int growth, std::size_t hardCount,
                         const StraightAttempt& attempt, double seconds) {
  std::string method = weighting.name;
  if (growth > 0) method += " + enlarged " + std::to_string(growth);
  rounds_.push_back(
      roundOf(std::move(method), hardCount, attempt.program, attempt.certificate, seconds));
}

}  // namespace hgp
