#include "distortion_run.h"

#include <string_view>

#include "cut_maps.h"
#include "hgp/base/check.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "least_squares_conformal.h"
#include "processor_time.h"
#include "slim.h"

namespace hgp::bench {
namespace {

/// A surface with its cones and its plain map, with which all other maps are compared.
class Comparison {
 public:
  Comparison(const TriMesh& mesh, SurfaceRow& row) : mesh_(mesh), row_(row) {
    start_ = processorSeconds();
    surface_.emplace(mesh);
    row.genus = surface_->topology().genus;
    row.loops = static_cast<int>(surface_->topology().loops.size());
  }

  bool solvePlain(int q) {
    SuggestOptions suggest;
    suggest.q = q;
    Result<CompleteSpec> spec = suggestCones(*surface_, suggest);
    if (!spec) return fail(spec.error().message);
    spec_ = std::move(*spec);
    Result<Parametrization> plain = parametrize(*surface_, toSpec(spec_), {});
    if (!plain) return fail(plain.error().message);
    plain_ = std::move(*plain);
    add(measured(kPlain, plain_.certificate), processorSeconds() - start_);
    if (!plain_.isCertified) row_.maps.back().note = plain_.certificate.reasons[0].message;
    return true;
  }

  /// Measures an improved map; its time is that from the start of the improvement to the end of the run.
  void improve(const char* name, double balance) {
    ParametrizeOptions options;
    options.improve.emplace().balance = balance;
    double began = 0.0;
    options.progress = [&](const ProgressReport& report) {
      if (began == 0.0 && report.stage == Stage::kImprove) began = processorSeconds();
      return true;
    };
    const Result<Parametrization> run = parametrize(*surface_, toSpec(spec_), options);
    const double ended = processorSeconds();
    if (!run) return;
    add(measured(name, run->certificate), ended - began);
    if (!run->improvement) return;
    row_.maps.back().steps = static_cast<int>(run->improvement->steps.size());
    row_.maps.back().note = outcomeName(run->improvement->outcome);
    if (!run->improvement->isKept) row_.maps.back().note += ", not kept";
  }

  /// Computes the cut and the unknowns of the plain map; false if they do not reproduce it.
  bool setUp() {
    std::vector<StageTime> times;
    Result<SeamlessSetup> setup = prepareSeamless(*surface_, toSpec(spec_), {}, times);
    if (!setup) return fail(setup.error().message);
    setup_.emplace(std::move(*setup));
    double gap = 0.0;
    x_ = unknownsOf(setup_->unknowns, plain_.map, gap);
    if (gap < 1e-9 * (1.0 + x_.cwiseAbs().maxCoeff())) return true;
    return fail(formatText("the unknowns miss the map by %g", gap));
  }

  void seamlessSlim(double limit) { descend(kSeamlessSlim, setup_->unknowns, x_, limit); }

  void freeSlim(double limit) {
    const ReducedUnknowns unknowns = freeUnknowns(setup_->cut);
    descend(kFreeSlim, unknowns, setup_->unknowns.copies * x_, limit);
  }

  void leastSquares() {
    const ReducedUnknowns unknowns = freeUnknowns(setup_->cut);
    const ReducedMap reduced{mesh_, setup_->context->geometry, setup_->cut, unknowns};
    const double start = processorSeconds();
    const auto [a, b] = farApart(mesh_, setup_->cut);
    std::vector<char> isHeld(at(unknowns.count), 0);
    isHeld[at(a)] = isHeld[at(b)] = 1;
    Eigen::VectorXcd x = Eigen::VectorXcd::Zero(unknowns.count);
    x[b] = 1.0;
    const FaceTerms terms(reduced, isHeld, x);
    const Eigen::VectorXcd free = leastSquaresConformal(terms);
    const double seconds = processorSeconds() - start;
    if (free.size() == 0) return;
    terms.free().scatter(free, x);
    certifyAndAdd(kLscm, x, seconds);
  }

 private:
  bool fail(const std::string& message) {
    row_.failure = message;
    return false;
  }
  void add(MeasuredMap map, double seconds) {
    map.seconds = seconds;
    map.cones = static_cast<int>(spec_.cones.size());
    row_.maps.push_back(std::move(map));
  }
  void certifyAndAdd(const char* name, const Eigen::VectorXcd& z, double seconds) {
    const UvMap map = layOut(mesh_, *setup_, {z.data(), z.data() + z.size()});
    add(measured(name, certify(mesh_, spec_, map)), seconds);
  }

  void descend(const char* name, const ReducedUnknowns& unknowns, const Eigen::VectorXcd& x,
               double limit) {
    const ReducedMap reduced{mesh_, setup_->context->geometry, setup_->cut, unknowns};
    const std::vector<char> none(at(unknowns.count), 0);
    const double start = processorSeconds();
    const FaceTerms terms(reduced, none, x);
    const double scale = dirichletScale(terms, terms.free().gather(x));
    SlimOptions options;
    options.maxSeconds = limit;
    const SlimResult run = slim(terms, terms.free().gather(x) / scale, options);
    const double seconds = processorSeconds() - start;
    Eigen::VectorXcd end = x;
    terms.free().scatter(run.free, end);
    certifyAndAdd(name, unknowns.copies * end, seconds);
    row_.maps.back().steps = static_cast<int>(run.energies.size()) - 1;
    if (run.isLate) row_.maps.back().note = "time limit";
  }

  const TriMesh& mesh_;
  SurfaceRow& row_;
  double start_ = 0.0;
  std::optional<PreparedSurface> surface_;
  CompleteSpec spec_;
  Parametrization plain_;
  std::optional<SeamlessSetup> setup_;
  Eigen::VectorXcd x_;
};

SurfaceRow rowOf(const std::string& name, const TriMesh& mesh, int q) {
  SurfaceRow row;
  row.name = name;
  row.triangles = mesh.faceCount();
  row.q = q;
  return row;
}

}  // namespace

SurfaceRow compareMaps(const std::string& name, const TriMesh& mesh,
                       const DistortionOptions& options) {
  SurfaceRow row = rowOf(name, mesh, options.q);
  Comparison comparison(mesh, row);
  if (!comparison.solvePlain(options.q) || !row.maps.back().isCertified) return row;
  comparison.improve(kIsometric, 0.0);
  comparison.improve(kConformal, -1.0);
  if (!options.hasComparators || !comparison.setUp()) return row;
  comparison.seamlessSlim(options.slimSeconds);
  comparison.freeSlim(options.slimSeconds);
  comparison.leastSquares();
  return row;
}

SurfaceRow compareCones(const std::string& name, const TriMesh& mesh, int q) {
  SurfaceRow row = rowOf(name, mesh, q);
  PreparedSurface surface(mesh);
  row.genus = surface.topology().genus;
  row.loops = static_cast<int>(surface.topology().loops.size());
  if (const Status done = surface.requireConnection(); !done) return row;
  int count = 0;
  const auto choose = [&](const char* label, const auto& suggest) {
    const double start = processorSeconds();
    const Result<HolonomySpec> spec = suggest();
    const double seconds = processorSeconds() - start;
    if (!spec) return;
    if (std::string_view(label) == kFieldCones) count = static_cast<int>(spec->cones.size());
    const Result<Parametrization> run = parametrize(surface, *spec, {});
    if (!run) return;
    row.maps.push_back(measured(label, run->certificate));
    row.maps.back().cones = static_cast<int>(spec->cones.size());
    row.maps.back().seconds = seconds;
  };
  SuggestOptions options;
  options.q = q;
  choose(kFieldCones, [&] { return fieldCones(surface, options); });
  const auto suggested = [&]() -> Result<HolonomySpec> {
    Result<CompleteSpec> spec = suggestCones(surface, options);
    if (!spec) return std::move(spec).error();
    return toSpec(*spec);
  };
  for (const ConesFor choice : {ConesFor::kBalanced, ConesFor::kFew, ConesFor::kLowDistortion}) {
    options.conesFor = choice;
    choose(conesForName(choice), suggested);
  }
  options.coneCount = count;
  if (count > 0) choose(kFieldCount, suggested);
  return row;
}

}  // namespace hgp::bench
