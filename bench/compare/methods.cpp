#include "methods.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "conformal_metric.h"
#include "draw.h"
#include "hgp/base/check.h"
#include "hgp/cones/choose_cones.h"
#include "hgp/optimize/program.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "processor_time.h"
#include "unfold.h"

namespace hgp::bench {
namespace {

constexpr Method kMethods[] = {Method::kAuto, Method::kHarmonic, Method::kSoft, Method::kPrinted,
                               Method::kAllFrames};
constexpr const char* kFieldChoice = "field";
constexpr const char* kOrbifold = "orbifold";

std::optional<stress::Family> familyNamed(const std::string& choice) {
  for (const stress::Family family : stress::kFamilies)
    if (choice == stress::familyName(family)) return family;
  return {};
}

double distance(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Four vertices, each as far as possible from the previous ones.
HolonomySpec orbifoldCones(const TriMesh& mesh) {
  HolonomySpec spec;
  spec.q = 2;
  std::vector<double> nearest(static_cast<std::size_t>(mesh.vertexCount()), 1e300);
  const auto farthestFrom = [&](VertexId from) {
    for (VertexId v : mesh.vertices()) {
      double& d = nearest[static_cast<std::size_t>(v.i)];
      d = std::min(d, distance(mesh.position(from), mesh.position(v)));
    }
    const auto farthest = std::max_element(nearest.begin(), nearest.end());
    return VertexId(static_cast<int>(farthest - nearest.begin()));
  };
  VertexId next = farthestFrom(VertexId(0));
  std::fill(nearest.begin(), nearest.end(), 1e300);
  for (int n = 0; n < 4; ++n) {
    spec.cones.push_back({next, 1});
    next = farthestFrom(next);
  }
  return spec;
}

Result<HolonomySpec> askedFor(const std::string& choice, const std::string& name,
                              PreparedSurface& surface, const CompareOptions& options) {
  const Topology& topology = surface.topology();
  const Failure none{ErrorCode::kPrescription, "compare", "does not apply", {}};
  if (choice == kOrbifold) {
    if (topology.genus > 0 || !topology.loops.empty()) return none;
    return orbifoldCones(surface.mesh());
  }
  if (const auto family = familyNamed(choice)) {
    stress::Random random(formatText("%llu/%s/%s", static_cast<unsigned long long>(options.seed),
                                     choice.c_str(), name.c_str()));
    auto spec = stress::draw(surface.mesh(), topology, *family, random);
    if (!spec) return none;
    return std::move(*spec);
  }
  SuggestOptions suggest;
  suggest.q = options.q;
  if (choice == kFieldChoice) return fieldCones(surface, suggest);
  suggest.conesFor = conesForNamed(choice).value_or(ConesFor::kBalanced);
  Result<CompleteSpec> spec = suggestCones(surface, suggest);
  if (!spec) return std::move(spec).error();
  return toSpec(*spec);
}

class Comparison {
 public:
  Comparison(const TriMesh& mesh, const CompleteSpec& spec, const CompareOptions& options,
             SurfaceRow& row)
      : mesh_(mesh), spec_(spec), options_(options), row_(row) {}

  void ours(Method method) {
    begin();
    ParametrizeOptions options;
    options.method = method;
    options.progress = [&](const ProgressReport&) { return spent() < options_.methodSeconds; };
    add(methodName(method), parametrize(mesh_, toSpec(spec_), options));
  }

  /// Maps a disk to a regular polygon; its boundary turning is not the prescribed one.
  void convex() {
    begin();
    add(kConvex, parametrizeConvex(mesh_, {}));
    row_.maps.back().cones = 0;
  }

  /// Only the harmonic rows and the seams' rotations; of all such maps the most conformal one, which on orbifolds is
  /// the only one [Aigerman and Lipman 2015].
  void withoutFrames() {
    begin();
    std::vector<StageTime> times;
    PreparedSurface surface(mesh_);
    const Result<SeamlessSetup> setup = prepareSeamless(surface, toSpec(spec_), {}, times);
    if (!setup) return addNothing(kNoFrames, setup.error().message);
    ProgramOptions program;
    program.u = setup->field.u;
    const ProgramResult solved = solveProgram(systemOf(mesh_, *setup), Frames{}, program);
    certifyAndAdd(kNoFrames, layOut(mesh_, *setup, solved.z));
  }

  void conformal() {
    begin();
    const FieldContext context = prepareSurface(mesh_);
    ConformalOptions options;
    options.maxSeconds = options_.methodSeconds;
    const ConformalMetric metric =
        conformalMetric(mesh_, context.geometry, context.topology, context.surface, spec_, options);
    if (!metric.isFound) {
      addNothing(kCetm, metric.isLate       ? "time limit"
                        : metric.broken > 0 ? formatText("%d triangles break the triangle "
                                                         "inequality",
                                                         metric.broken)
                                            : formatText("angles are off by %.1g after %d steps",
                                                         metric.residual, metric.steps));
      row_.maps.back().steps = metric.steps;
      return;
    }
    std::vector<VertexId> cones;
    for (const ConePoint& cone : spec_.cones) cones.push_back(cone.vertex);
    const CutMesh cut =
        cutToDisk(mesh_, seamGraph(mesh_, context.geometry, context.surface, cones), cones);
    certifyAndAdd(kCetm, layOut(mesh_, context.geometry, cut, unfold(mesh_, cut, metric.length)));
    row_.maps.back().steps = metric.steps;
  }

 private:
  void begin() { began_ = processorSeconds(); }
  double spent() const { return processorSeconds() - began_; }

  void addMap(MeasuredMap map) {
    map.seconds = spent();
    map.cones = static_cast<int>(spec_.cones.size());
    row_.maps.push_back(std::move(map));
  }
  void add(const char* name, const Result<Parametrization>& run) {
    if (!run) {
      const bool isLate = run.error().code == ErrorCode::kCancelled;
      return addNothing(name, isLate ? "time limit" : run.error().message);
    }
    addMap(measured(name, run->certificate));
    row_.maps.back().steps = static_cast<int>(run->rounds.size());
  }
  void addNothing(const char* name, const std::string& why) {
    MeasuredMap map;
    map.name = name;
    map.verdict = "no map";
    map.note = why;
    addMap(std::move(map));
  }
  void certifyAndAdd(const char* name, const UvMap& map) {
    const double seconds = spent();
    addMap(measured(name, certify(mesh_, spec_, map)));
    row_.maps.back().seconds = seconds;
  }

  const TriMesh& mesh_;
  const CompleteSpec& spec_;
  const CompareOptions& options_;
  SurfaceRow& row_;
  double began_ = 0.0;
};

}  // namespace

bool isChoice(const std::string& choice) {
  return choice == kFieldChoice || choice == kOrbifold || familyNamed(choice) ||
         conesForNamed(choice);
}

SurfaceRow compareMethods(const std::string& name, const TriMesh& mesh, const std::string& choice,
                          const CompareOptions& options) {
  PreparedSurface surface(mesh);
  SurfaceRow row;
  row.name = name;
  row.choice = choice;
  row.triangles = mesh.faceCount();
  row.genus = surface.topology().genus;
  row.loops = static_cast<int>(surface.topology().loops.size());
  const Result<HolonomySpec> asked = askedFor(choice, name, surface, options);
  if (!asked || !surface.requireConnection()) return row;
  const Result<PrescribedField> field = surface.field(*asked);
  if (!field) return row;
  const CompleteSpec spec = field->spec;
  row.q = spec.q;
  Comparison comparison(mesh, spec, options, row);
  for (const Method method : kMethods) comparison.ours(method);
  comparison.withoutFrames();
  if (row.genus == 0 && row.loops == 1 && choice == conesForName(ConesFor::kBalanced))
    comparison.convex();
  comparison.conformal();
  return row;
}

}  // namespace hgp::bench
