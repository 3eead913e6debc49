#include "hgp/parametrize/strategy/state.h"

#include <algorithm>
#include <cmath>

#include "hgp/optimize/harmonic_basis.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

/// δ of the weighting "light distortion term", for prescribed cones whose map is badly determined without it.
constexpr double kLightQuality = 1e-3;
/// δ of the program whose minimiser leads to the harmonic map of least distortion (nearestHarmonic). The smaller it is, the
/// fewer steps (with 10 000 boundary edges 5, while 1e-5 takes 11 and 1e-4 31), and the fewer digits the factor leaves of
/// what the rows do not determine.
constexpr double kHarmonicQuality = 1e-6;
/// Weight of soft frame constraints, of the order of the weight of harmonic rows (0.1 to 1 work equally
/// well).
constexpr double kSoft = 0.3;
constexpr double kClamp = 5.0;
/// Range of u up to which one linear system usually gives the map (automatic cones: 0.9 to 5.6
/// on all meshes of the corpus).
constexpr double kMildScaleRange = 8.0;

/// The number of unknowns up to which the dense system costs a fraction of the sparse one, which costs |V|^1.5.
int cheapRoot(const TriMesh& mesh) {
  return static_cast<int>(2.0 * std::sqrt(static_cast<double>(mesh.vertexCount())));
}

int touchedUnknowns(const Problem& problem, const std::vector<FaceId>& faces) {
  PerVertex<char> isTouched(static_cast<std::size_t>(problem.mesh.vertexCount()), 0);
  for (FaceId f : faces)
    for (VertexId v : problem.mesh.corners(f)) isTouched[v] = 1;
  const std::vector<int>& chains = problem.setup->unknowns.chainUnknown;
  return static_cast<int>(
      std::count(isTouched.raw().begin(), isTouched.raw().end(), 1) +
      std::count_if(chains.begin(), chains.end(), [](int unknown) { return unknown >= 0; }));
}

/// Where the scale of the cone metric varies little, and on disks, some map near the conformal one has these cones.
bool isMild(const SeamlessSetup& setup) {
  const Topology& topology = setup.context->topology;
  if (topology.genus == 0 && topology.loops.size() == 1) return true;
  return setup.field.scaleRange <= kMildScaleRange;
}

/// Flat tori and orbifolds of the sphere have an exactly harmonic map, which needs no soft constraints.
bool suitsSoft(const SeamlessSetup& setup) {
  const Topology& topology = setup.context->topology;
  const bool isClosed = topology.loops.empty();
  if (isClosed && (setup.cones.empty() || (topology.genus == 0 && setup.cones.size() <= 4)))
    return false;
  return isMild(setup);
}

/// Soft constraints on F_cb, and a ring around it where the dense root stays small.
Weighting softWeighting(Problem& problem) {
  const bool isExact = touchedUnknowns(problem, problem.base) <= kLargestExactRoot;
  problem.soft = problem.base;
  std::vector<FaceId> more = growFaces(problem.mesh, problem.base, 1);
  if (isExact &&
      touchedUnknowns(problem, more) <= std::min(cheapRoot(problem.mesh), kLargestExactRoot))
    problem.soft = std::move(more);
  return {isExact ? "soft constraints, exact rows" : "soft constraints",
          kNoClamp,
          0.0,
          3,
          false,
          isExact,
          kSoft};
}

/// Harmonic maps, first for the paper's weights. Flat tori have none for these (HarmonicBasis).
/// @param isCompared  also for cotangent weights, if the others give a map of much distortion
void addHarmonic(Problem& problem, bool isCompared) {
  const SeamlessSetup& setup = *problem.setup;
  const bool isTorus = setup.cones.empty() && setup.context->topology.loops.empty();
  Weighting meanValue{"harmonic", kNoClamp, 0.0, 0, false, false, 0.0, true};
  const bool hasBasis = problem.harmonicCount <= kLargestExactRoot;
  if (!hasBasis) meanValue.quality = kHarmonicQuality;
  Weighting cotangent = meanValue;
  cotangent.name = "harmonic for cotangent weights";
  cotangent.rows = WeightKind::kCotangent;
  if (!isTorus) problem.weightings.push_back(meanValue);
  if (isTorus || isCompared) problem.weightings.push_back(cotangent);
}

class Hash {
 public:
  void add(std::uint64_t value) {
    value_ ^= value + 0x9e3779b97f4a7c15ULL + (value_ << 6) + (value_ >> 2);
    value_ *= 0xff51afd7ed558ccdULL;
  }
  void add(const std::vector<FaceId>& faces) {
    add(faces.size());
    for (FaceId f : faces) add(static_cast<std::uint64_t>(f.i));
  }
  void add(const std::vector<ConePoint>& cones) {
    add(cones.size());
    for (const ConePoint& c : cones) add(static_cast<std::uint64_t>(c.vertex.i));
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0;
};

}  // namespace

Problem problemOf(const TriMesh& mesh, const std::shared_ptr<const SeamlessSetup>& setup,
                  const ParametrizeOptions& options) {
  Problem problem{
      mesh,
      setup,
      options.method,
      {},
      coneAndBoundaryFaces(mesh, setup->cones),
      {},
      options.frames.has_value(),
      HarmonicBasis::countOf(systemOf(mesh, *setup)),
      options.maxStepsPerFace * std::max(mesh.faceCount(), ParametrizeOptions::kSmallSurface),
      std::make_shared<AngleFrames>()};
  const Weighting hard{"hard constraints", kNoClamp, 0.0, 3, false};
  const Method method = options.method;
  if (method == Method::kHarmonic || (method == Method::kAuto && isMild(*setup)))
    addHarmonic(problem, method == Method::kAuto && suitsSoft(*setup));
  if (method == Method::kSoft || (method == Method::kAuto && suitsSoft(*setup)))
    problem.weightings.push_back(softWeighting(problem));
  if (method == Method::kHarmonic || method == Method::kAuto) problem.weightings.push_back(hard);
  if (method == Method::kAuto) {
    const double light = kLightQuality;
    problem.weightings.push_back({"light distortion term", kNoClamp, light, 3, false});
    problem.weightings.push_back({"clamped weights", kClamp, 0.0, 4, false});
    problem.weightings.push_back({"scale of the last map", kNoClamp, light, 4, true});
  }
  if (method == Method::kPrinted)
    problem.weightings.push_back({"as printed", kNoClamp, 0.0, 0, false});
  if (method == Method::kAllFrames) {
    problem.weightings.push_back({"all frames", kNoClamp, 0.0, 0, false});
    problem.base.clear();
    for (FaceId f : mesh.faces()) problem.base.push_back(f);
  }
  return problem;
}

std::uint64_t hashOf(const State& state) {
  Hash hash;
  hash.add(state.weighting);
  hash.add(state.hard);
  hash.add(state.patch);
  hash.add(state.lifts);
  hash.add(static_cast<std::uint64_t>(state.framedBy));
  hash.add(static_cast<std::uint64_t>(state.untangling + 1));
  // These are taken from the previous map: held values of a patch, lifts, scale, frames.
  const bool usesMap = !state.patch.empty() || !state.lifts.empty() || state.directions ||
                       state.framedBy == FramedBy::kMap;
  if (usesMap && state.from)
    for (const Complex& x : state.from->program.x) {
      hash.add(Eigen::numext::bit_cast<std::uint64_t>(x.real()));
      hash.add(Eigen::numext::bit_cast<std::uint64_t>(x.imag()));
    }
  return hash.value();
}

double faceStepsOf(const Round& round, int faceCount) {
  constexpr double kPerConstraint = 6.0;
  return std::max(1, round.iterations) *
         (faceCount + kPerConstraint * static_cast<double>(round.constrainedTriangles));
}

std::string nameOf(const Problem& problem, const State& state) {
  std::string name = state.untangling >= 0
                         ? "untangled, kind " + std::to_string(state.untangling + 1)
                         : problem.weightings[state.weighting].name;
  if (state.framedBy == FramedBy::kAngles) name += ", frames of angles";
  if (state.framedBy == FramedBy::kMap) name += ", frames of the map";
  if (state.growth > 0)
    name += state.directions ? ", frames and weights of map " + std::to_string(state.growth)
                             : " + enlarged " + std::to_string(state.growth);
  if (!state.patch.empty()) name += state.isWide ? ", on a wide patch" : ", on a patch";
  if (!state.lifts.empty())
    name += ", frames fixed at " + std::to_string(state.lifts.size()) + " cones";
  return name;
}

State startOf(const Problem& problem, std::size_t weighting) {
  State state;
  state.weighting = weighting;
  const Weighting& kind = problem.weightings[weighting];
  if (kind.soft == 0.0 && !kind.isHarmonic) state.hard = problem.base;
  return state;
}

const std::vector<Untangling>& untanglings() {
  using enum FramedBy;
  static const std::vector<Untangling> kinds{
      {kAngles, 0.05, 0.2, true},     {kAngles, 3.0, 1.0, true},  {kConnection, 0.05, 0.2, true},
      {kConnection, 3.0, 1.0, false}, {kAngles, 0.3, 0.2, false}, {kConnection, 0.3, 0.2, false}};
  return kinds;
}

State firstState(const Problem& problem) { return startOf(problem, 0); }

}  // namespace hgp
