#include "hgp/parametrize/strategy/attempt.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/frame_fixing.h"
#include "hgp/optimize/kernels.h"
#include "hgp/optimize/program_form.h"
#include "hgp/optimize/untangle.h"

namespace hgp {
namespace {

/// δ of the linear program from which untangling starts: soft frames on all faces outweigh harmonicity.
constexpr double kStartQuality = 1.0;
/// Bound on |u| in that program if it cannot be factored otherwise.
constexpr double kStartClamp = 8.0;
/// Bound on |u| where u is that of a map, which may have triangles of almost no area.
constexpr double kMapClamp = 12.0;
/// ε of (13) as printed.
constexpr double kPrintedMargin = 0.01;

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Per vertex, the mean of log|f_z| over its faces.
PerVertex<double> scaleOfMap(const Problem& problem, const std::vector<Complex>& z) {
  const SeamlessSetup& setup = *problem.setup;
  PerVertex<double> sum(static_cast<std::size_t>(problem.mesh.vertexCount()), 0.0), count = sum;
  for (FaceId f : problem.mesh.faces()) {
    const LinearParts parts = linearParts(setup.context->geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k)
      similarity += parts.similarity[static_cast<std::size_t>(k)] *
                    z[static_cast<std::size_t>(setup.cut.copy[TriMesh::halfedge(f, k)].i)];
    const double log = portable::log(std::max(portable::abs(similarity), 1e-300));
    for (VertexId v : problem.mesh.corners(f)) {
      sum[v] += log;
      count[v] += 1.0;
    }
  }
  for (VertexId v : problem.mesh.vertices())
    if (count[v] > 0) sum[v] /= count[v];
  return sum;
}

/// A patch in which the unknowns of its vertices are free and all others keep their values in the previous map.
Patch patchOf(const Problem& problem, const State& state) {
  const ReducedUnknowns& unknowns = problem.setup->unknowns;
  Patch part{std::vector<char>(static_cast<std::size_t>(unknowns.count), 0), state.from->program.x};
  for (FaceId f : state.patch)
    for (VertexId v : problem.mesh.corners(f))
      if (unknowns.vertexUnknown[v] >= 0)
        part.isFree[static_cast<std::size_t>(unknowns.vertexUnknown[v])] = 1;
  return part;
}

/// Whether at least one corner of f is free in the patch; a triangle of three cones may have none.
bool isTouched(const Problem& problem, FaceId f, const Patch& part) {
  const auto corners = problem.mesh.corners(f);
  return std::any_of(corners.begin(), corners.end(), [&](VertexId v) {
    const int unknown = problem.setup->unknowns.vertexUnknown[v];
    return unknown >= 0 && part.isFree[static_cast<std::size_t>(unknown)];
  });
}

/// Finds the triangles that are not positive and those around vertices and loops with a wrong angle.
void findWrong(const Problem& problem, Attempt& attempt) {
  const Certificate& c = attempt.certificate;
  if (!c.isMeasured) return;
  std::vector<FaceId> faces = c.orientation.notPositive;
  attempt.wrongCount = static_cast<int>(faces.size() + c.angles.wrong.size());
  const auto addRing = [&](VertexId v) {
    for (HalfedgeId h : outgoingHalfedges(problem.mesh, v)) faces.push_back(TriMesh::face(h));
  };
  for (const MeasuredCone& cone : c.angles.wrong) addRing(cone.vertex);
  for (const MeasuredTurning& turning : c.angles.turnings) {
    if (!turning.isWrong) continue;
    ++attempt.wrongCount;
    const auto& loop =
        problem.setup->context->topology.loops[static_cast<std::size_t>(turning.loop.i)];
    for (HalfedgeId h : loop.halfedges) addRing(problem.mesh.tail(h));
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  attempt.wrong = std::move(faces);
}

}  // namespace

Attempts::Attempts(const Problem& problem, const ParametrizeOptions& options)
    : problem_(problem), options_(options), verifier_(problem.mesh) {}

/// The rotations of the seams belong to the prescription; only the frames between them differ.
const SeamRotations& Attempts::seamsOf(const State& state) const {
  return state.frames ? *state.frames : problem_.setup->seams;
}

PerVertex<double> Attempts::scaleOf(const State& state) const {
  const Weighting& weighting = problem_.weightings[state.weighting];
  const bool hasMap = state.from && !state.from->program.z.empty();
  const PrescribedField& field = problem_.setup->field;
  const bool isFromMap = weighting.isFromMap && hasMap && state.untangling < 0;
  PerVertex<double> u = isFromMap ? scaleOfMap(problem_, state.from->program.z) : field.u;
  const double clamp = state.untangling < 0 ? weighting.clamp : kNoClamp;
  // Weights that are clamped or come from a map already have a moderate range.
  const bool isMild = isFromMap || clamp < kNoClamp || field.scaleRange <= kWeightedScaleRange;
  const double share = isMild ? 1.0 : kWeightedScaleRange / field.scaleRange;
  const double median = medianOf(u.raw());
  for (double& value : u.raw()) value = share * std::clamp(value - median, -clamp, clamp);
  return u;
}

Frames Attempts::framesOf(const State& state) const {
  if (state.directions) return *state.directions;
  const SeamlessSetup& setup = *problem_.setup;
  const SeamRotations& seams = seamsOf(state);
  std::vector<FaceId> hard = state.hard;
  if (!state.patch.empty()) {
    const Patch part = patchOf(problem_, state);
    std::erase_if(hard, [&](FaceId f) { return !isTouched(problem_, f, part); });
  }
  Frames frames = fieldFrames(seams, std::move(hard));
  for (const ConePoint& cone : state.lifts)
    if (state.from && holdsRing(problem_.mesh, frames, cone.vertex))
      embedConeRing(problem_.mesh, setup.context->geometry, setup.cut, seams, state.from->program.z,
                    cone.vertex, cone.k, frames);
  return frames;
}

std::shared_ptr<const Attempt> Attempts::make(const State& state, int round) {
  auto attempt = std::make_shared<Attempt>();
  attempt->u = scaleOf(state);
  const bool isDone =
      state.untangling >= 0 ? untangleFrom(state, round, *attempt) : solve(state, round, *attempt);
  if (!isDone) return nullptr;
  attempt->map = layOut(problem_.mesh, *problem_.setup, attempt->program.z);
  attempt->certificate = verifier_.certify(toSpec(problem_.setup->field.spec), attempt->map);
  findWrong(problem_, *attempt);
  return attempt;
}

/// The harmonic rows of the state's weights.
const HarmonicSystem& Attempts::rowsOf(const State& state) {
  const SeamlessSetup& setup = *problem_.setup;
  if (state.harmonic) return *state.harmonic;
  if (problem_.weightings[state.weighting].rows == WeightKind::kMeanValue) return setup.harmonic;
  if (!cotangent_)
    cotangent_ = harmonicSystem(problem_.mesh, setup.context->geometry, setup.cut, setup.unknowns,
                                setup.seams.q, setup.cones, WeightKind::kCotangent);
  return *cotangent_;
}

std::shared_ptr<const HarmonicBasis> Attempts::basisOf(const State& state, const Attempt& attempt) {
  const SeamlessSetup& setup = *problem_.setup;
  if (!basis_ || basisWeighting_ != state.weighting)
    basis_ = HarmonicBasis::make(systemOf(problem_.mesh, setup, seamsOf(state), rowsOf(state)),
                                 attempt.u, setup.context->tree);
  basisWeighting_ = state.weighting;
  return basis_;
}

bool Attempts::solve(const State& state, int round, Attempt& attempt) {
  const SeamlessSetup& setup = *problem_.setup;
  const Weighting& weighting = problem_.weightings[state.weighting];
  attempt.frames = framesOf(state);
  if (!weighting.isHarmonic) basis_.reset();
  ProgramOptions program;
  program.u = attempt.u;
  if (problem_.method == Method::kPrinted) {
    program.u = PerVertex<double>(attempt.u.size(), 0.0);
    program.margin = kPrintedMargin;
  }
  if (weighting.soft > 0.0) program.soft = {problem_.soft, weighting.soft};
  if (!state.patch.empty())
    program.objective = PenaltyObjective{weighting.quality, patchOf(problem_, state)};
  else if (weighting.isHarmonic && weighting.quality > 0.0)
    program.objective =
        PenaltyObjective{weighting.quality, WholeSurface{}, &setup.context->wideTree->get(), true};
  else if (weighting.isHarmonic)
    program.objective = HarmonicObjective{basisOf(state, attempt)};
  else if (weighting.isExact)
    program.objective = ExactObjective(setup.context->tree);
  else
    program.objective =
        PenaltyObjective{weighting.quality, WholeSurface{}, &setup.context->wideTree->get()};
  bool isCancelled = false;
  program.progress = [&](int iteration, double residual) {
    const double fraction = 1.0 - 1.0 / (1.0 + 0.25 * iteration);
    isCancelled = !report(options_.progress, {Stage::kSolve, fraction, iteration, residual, round,
                                              options_.maxRounds});
    return !isCancelled;
  };
  attempt.program = solveProgram(systemOf(problem_.mesh, setup, seamsOf(state), rowsOf(state)),
                                 attempt.frames, program);
  return !isCancelled;
}

/// The scale that triangles are measured in: where the frames are those of a map, that of this map.
PerVertex<double> Attempts::untanglingScale(const State& state, const Attempt& attempt) const {
  const bool isOfMap =
      state.framedBy == FramedBy::kMap && state.from && !state.from->program.z.empty();
  if (!isOfMap) return attempt.u;
  PerVertex<double> u = scaleOfMap(problem_, state.from->program.z);
  const double median = medianOf(u.raw());
  for (double& value : u.raw()) value = std::clamp(value - median, -kMapClamp, kMapClamp);
  return u;
}

/// The least-squares solution with soft frames on all faces.
/// @param isFramed  with hard frames around cones and along the boundary, whose winding numbers are then right from the
///                  beginning, unless these frames contradict each other
ProgramResult Attempts::untanglingStart(const SeamlessSystem& system, const PerVertex<double>& u,
                                        bool isFramed) const {
  ProgramOptions start;
  start.u = u;
  start.objective =
      PenaltyObjective{kStartQuality, WholeSurface{}, &problem_.setup->context->wideTree->get()};
  if (isFramed) {
    ProgramResult hard = solveProgram(system, fieldFrames(system.seams, problem_.base), start);
    const bool isUsable = !socp::isWithoutPoint(hard.status) && hard.x.size() > 0;
    if (isUsable && hard.x.allFinite()) return hard;
  }
  ProgramResult linear = solveProgram(system, Frames{}, start);
  if (linear.x.size() > 0) return linear;
  // With these weights the factorization fails.
  for (double& value : start.u.raw()) value = std::clamp(value, -kStartClamp, kStartClamp);
  return solveProgram(system, Frames{}, start);
}

bool Attempts::untangleFrom(const State& state, int round, Attempt& attempt) {
  const SeamlessSetup& setup = *problem_.setup;
  const Untangling& kind = untanglings()[static_cast<std::size_t>(state.untangling)];
  const SeamlessSystem system = systemOf(problem_.mesh, setup, seamsOf(state), setup.harmonic);
  UntangleOptions options;
  options.u = untanglingScale(state, attempt);
  const ProgramResult start = untanglingStart(system, options.u, kind.startsFramed);
  attempt.program.status = socp::SolveStatus::kStalled;
  if (start.x.size() == 0 || !start.x.allFinite()) return true;
  options.kept = problem_.base;
  options.scaleWeight = kind.scaleWeight;
  options.epsilonShare = kind.epsilonShare;
  options.progress = [&](int iteration, double wrong) {
    const double fraction = 1.0 - 1.0 / (1.0 + 0.02 * iteration);
    return report(options_.progress,
                  {Stage::kSolve, fraction, iteration, wrong, round, options_.maxRounds});
  };
  UntangleResult result = untangle(system, start.x, options);
  if (result.flipped > 0 && !result.isCancelled) moveIntoKernels(system, result);
  attempt.program.x = result.x;
  attempt.program.iterations = result.iterations;
  if (result.flipped == 0) attempt.program.status = socp::SolveStatus::kOptimal;
  const Eigen::VectorXcd z = setup.unknowns.copies * result.x;
  attempt.program.z.assign(z.data(), z.data() + z.size());
  attempt.program.laplacianEnergy = (setup.harmonic.rows * result.x).squaredNorm();
  return !result.isCancelled;
}

}  // namespace hgp
