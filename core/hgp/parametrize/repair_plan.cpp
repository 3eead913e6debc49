#include "hgp/parametrize/repair_plan.h"

#include <algorithm>
#include <cmath>

#include "hgp/optimize/frame_fixing.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

/// The distortion term of `--quality`, and the lighter one that steadies prescribed cones.
constexpr double kQuality = 1e-2;
constexpr double kLightQuality = 1e-3;
/// Weight of frames that pull instead of bind, of the order of the harmonic rows' own (0.1 to 1 do
/// equally well).
constexpr double kPull = 0.3;
/// What one linear system leaves wrong is mended within this many rings around it, and within the
/// larger number where that was not enough, while the patch is at most this share of the faces.
constexpr int kPatchRings = 6;
constexpr int kWidePatchRings = 24;
constexpr double kPatchShare = 0.25;
constexpr double kClamp = 5.0;
constexpr double kLinearScaleRange = 8.0;
constexpr double kNoClamp = 1e9;

/// Unknowns whose dense system costs a fraction of the sparse one, which grows like |V|^1.5.
int cheapRoot(const TriMesh& mesh) {
  return static_cast<int>(2.0 * std::sqrt(static_cast<double>(mesh.vertexCount())));
}

/// Whether one linear system most likely does: on disks, and where the cone metric asks for little
/// (automatic cones: 0.9 to 5.6 on all meshes we have). Flat tori and orbifolds of the sphere have an
/// exactly harmonic map, which frames that bind find.
bool suitsLinear(const SeamlessSetup& setup) {
  const Topology& topology = setup.context->topology;
  if (topology.genus == 0 && topology.loops.size() == 1) return true;
  const bool isClosed = topology.loops.empty();
  if (isClosed && (setup.cones.empty() || (topology.genus == 0 && setup.cones.size() <= 4)))
    return false;
  return setup.field.scaleRange <= kLinearScaleRange;
}

double medianOf(std::vector<double> values) {
  if (values.empty()) return 0.0;
  auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

RepairPlan::RepairPlan(const TriMesh& mesh, const SeamlessSetup& setup, bool useQuality)
    : mesh_(mesh), setup_(setup) {
  const double quality = useQuality ? kQuality : 0.0;
  rungs_ = {
      {"weighted", kNoClamp, quality, 3, false},
      {"weighted, light distortion term", kNoClamp, std::max(quality, kLightQuality), 3, false},
      {"clamped weights", kClamp, quality, 4, false},
      {"scale of the last map", kNoClamp, std::max(quality, kLightQuality), 4, true}};
  base_ = coneAndBoundaryFaces(mesh, setup.cones);
  if (suitsLinear(setup)) {
    const bool isExact = !useQuality && touchedUnknowns(base_) <= kLargestExactRoot;
    pulled_ = base_;
    std::vector<FaceId> more = growFaces(mesh, base_, 1);
    if (isExact && touchedUnknowns(more) <= std::min(cheapRoot(mesh), kLargestExactRoot))
      pulled_ = std::move(more);
    rungs_.insert(rungs_.begin(), {isExact ? "linear, exactly harmonic" : "linear", kNoClamp,
                                   quality, 3, false, isExact, kPull});
  }
  startRung();
}

int RepairPlan::touchedUnknowns(const std::vector<FaceId>& faces) const {
  PerVertex<char> isTouched(static_cast<std::size_t>(mesh_.vertexCount()), 0);
  for (FaceId f : faces)
    for (VertexId v : mesh_.corners(f)) isTouched[v] = 1;
  return static_cast<int>(std::count(isTouched.raw().begin(), isTouched.raw().end(), 1) +
                          std::count_if(setup_.unknowns.chainUnknown.begin(),
                                        setup_.unknowns.chainUnknown.end(),
                                        [](int unknown) { return unknown >= 0; }));
}

void RepairPlan::startRung() {
  if (rung_ >= rungs_.size()) return;
  growth_ = 0;
  patch_.clear();
  patchRings_ = kPatchRings;
  faces_ = rungs_[rung_].pull > 0.0 ? std::vector<FaceId>() : base_;
  const PerVertex<double> before = u_;
  u_ = weightsOf(rungs_[rung_]);
  // Where nothing is clamped the rung repeats an earlier one.
  if (rungs_[rung_].clamp < kNoClamp && before.size() && before.raw() == u_.raw()) {
    ++rung_;
    startRung();
  }
}

PerVertex<double> RepairPlan::weightsOf(const Rung& rung) const {
  PerVertex<double> u = rung.isFromMap ? scaleOfMap() : setup_.field.u;
  const double median = medianOf(u.raw());
  for (double& value : u.raw()) value = std::clamp(value - median, -rung.clamp, rung.clamp);
  return u;
}

PerVertex<double> RepairPlan::scaleOfMap() const {
  if (lastMap_.empty()) return setup_.field.u;
  PerVertex<double> sum(static_cast<std::size_t>(mesh_.vertexCount()), 0.0), count = sum;
  for (FaceId f : mesh_.faces()) {
    const LinearParts parts = linearParts(setup_.context->geometry, f);
    Complex similarity = 0.0;
    for (int k = 0; k < 3; ++k)
      similarity += parts.similarity[static_cast<std::size_t>(k)] *
                    lastMap_[static_cast<std::size_t>(setup_.cut.copy[TriMesh::halfedge(f, k)].i)];
    const double log = std::log(std::max(std::abs(similarity), 1e-300));
    for (VertexId v : mesh_.corners(f)) {
      sum[v] += log;
      count[v] += 1.0;
    }
  }
  for (VertexId v : mesh_.vertices())
    if (count[v] > 0) sum[v] /= count[v];
  return sum;
}

std::optional<RepairStep> RepairPlan::next() {
  if (rung_ >= rungs_.size()) return {};
  RepairStep step;
  step.method = rungs_[rung_].name;
  if (growth_ > 0) step.method += " + growth " + std::to_string(growth_);
  step.u = u_;
  step.quality = rungs_[rung_].quality;
  step.isExact = rungs_[rung_].isExact;
  step.pull = rungs_[rung_].pull;
  if (step.pull > 0.0) step.pulled = pulled_;
  std::vector<FaceId> bound = faces_;
  if (!patch_.empty()) {
    step.method += patchRings_ == kPatchRings ? ", locally" : ", on a wide patch";
    step.isExact = false;
    step.local = partOf(patch_);
    std::erase_if(bound, [&](FaceId f) { return !isTouched(f, *step.local); });
  }
  step.frames = fieldFrames(setup_.seams, std::move(bound));
  for (const ConePoint& cone : ringCones_)
    embedSurfaceRing(mesh_, setup_.context->geometry, setup_.seams, cone.vertex, cone.k,
                     step.frames);
  for (const ConePoint& cone : fixedCones_)
    embedConeRing(mesh_, setup_.context->geometry, setup_.cut, setup_.seams, lastMap_, cone.vertex,
                  cone.k, step.frames);
  if (!fixedCones_.empty())
    step.method += ", frames fixed at " + std::to_string(fixedCones_.size()) + " cones";
  if (!ringCones_.empty())
    step.method += ", " + std::to_string(ringCones_.size()) + " rings embedded";
  return step;
}

LocalPart RepairPlan::partOf(const std::vector<FaceId>& patch) const {
  LocalPart part{std::vector<char>(static_cast<std::size_t>(setup_.unknowns.count), 0),
                 lastUnknowns_};
  for (FaceId f : patch)
    for (VertexId v : mesh_.corners(f)) {
      const int unknown = setup_.unknowns.vertexUnknown[v];
      if (unknown >= 0) part.isFree[static_cast<std::size_t>(unknown)] = 1;
    }
  return part;
}

/// Whether a corner may move; where all three are cones, none can.
bool RepairPlan::isTouched(FaceId f, const LocalPart& part) const {
  const auto corners = mesh_.corners(f);
  return std::any_of(corners.begin(), corners.end(), [&](VertexId v) {
    const int unknown = setup_.unknowns.vertexUnknown[v];
    return unknown >= 0 && part.isFree[static_cast<std::size_t>(unknown)];
  });
}

std::vector<FaceId> RepairPlan::wrongFaces(const Certificate& certificate) const {
  std::vector<FaceId> faces = certificate.orientation.notPositive;
  for (const MeasuredCone& cone : certificate.angles.wrong)
    for (HalfedgeId h : outgoingHalfedges(mesh_, cone.vertex)) faces.push_back(TriMesh::face(h));
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

std::vector<FaceId> RepairPlan::smallPatchAround(const std::vector<FaceId>& faces) const {
  if (lastUnknowns_.size() == 0 || !lastUnknowns_.allFinite()) return {};
  std::vector<FaceId> patch = growFaces(mesh_, faces, patchRings_);
  if (static_cast<double>(patch.size()) > kPatchShare * mesh_.faceCount()) patch.clear();
  return patch;
}

bool RepairPlan::embedConflictingRings(const std::vector<FaceId>& conflict) {
  PerVertex<char> isHit(static_cast<std::size_t>(mesh_.vertexCount()), 0);
  for (FaceId f : conflict)
    for (VertexId v : mesh_.corners(f)) isHit[v] = 1;
  for (const ConePoint& cone : ringCones_) isHit[cone.vertex] = 0;
  const std::size_t before = ringCones_.size();
  for (const ConePoint& cone : setup_.field.spec.cones)
    if (isHit[cone.vertex]) ringCones_.push_back(cone);
  return ringCones_.size() > before;
}

bool RepairPlan::fixLifts(const Certificate& certificate) {
  PerFace<char> isWrong(static_cast<std::size_t>(mesh_.faceCount()), 0);
  for (FaceId f : certificate.orientation.notPositive) isWrong[f] = 1;
  bool isChanged = false;
  for (const MeasuredCone& wrong : certificate.angles.wrong) {
    const auto& cones = setup_.field.spec.cones;
    const auto cone = std::find_if(cones.begin(), cones.end(),
                                   [&](const ConePoint& c) { return c.vertex == wrong.vertex; });
    // An angle that is as asked, but not exactly enough, has no wrong lift.
    const int off = wrong.measured - wrong.asked;
    bool isPositive = cone != cones.end() && off != 0 && off % setup_.seams.q == 0;
    if (!isPositive) continue;
    for (HalfedgeId h : outgoingHalfedges(mesh_, wrong.vertex))
      isPositive &= !isWrong[TriMesh::face(h)];
    if (!isPositive) continue;
    const auto isThis = [&](const ConePoint& c) { return c.vertex == wrong.vertex; };
    if (std::erase_if(ringCones_, isThis) > 0) {
      isChanged = true;
    } else if (std::none_of(fixedCones_.begin(), fixedCones_.end(), isThis)) {
      fixedCones_.push_back(*cone);
      isChanged = true;
    }
  }
  return isChanged;
}

void RepairPlan::learn(const ProgramResult& program, const Certificate& certificate) {
  const bool wasLocal = !patch_.empty();
  patch_.clear();
  if (!program.conflict.empty() && embedConflictingRings(program.conflict)) {
    growth_ = 0;
    faces_ = base_;
    return;
  }
  if (!program.z.empty()) lastMap_ = program.z;  // what rings are embedded from
  const bool isBound = rungs_[rung_].pull == 0.0;
  if (isBound && certificate.isMeasured && fixLifts(certificate)) return;
  const std::vector<FaceId> wrong =
      certificate.isMeasured ? wrongFaces(certificate) : std::vector<FaceId>();
  const std::size_t wrongCount =
      certificate.orientation.notPositive.size() + certificate.angles.wrong.size();
  const bool wasWide = patchRings_ == kWidePatchRings;
  if (wasLocal) patchRings_ = kWidePatchRings;
  if (wasLocal && wrongCount > wrongCount_) {
    // Held too close: once more from the map before, with more of it free.
    if (!wasWide) patch_ = smallPatchAround(growFaces(mesh_, wrong_, 1));
    if (patch_.empty()) {
      ++rung_;
      startRung();
    }
    return;
  }
  wrong_ = wrong;
  wrongCount_ = wrongCount;
  lastUnknowns_ = program.x;
  // Growing helps while something new can be constrained and it stays a small part of the mesh.
  // Frames that pull grow to no more than what the next rung would bind anyway.
  const std::size_t limit =
      isBound ? static_cast<std::size_t>(mesh_.faceCount()) / 4 + base_.size() : base_.size();
  const std::vector<FaceId> grown = growFaces(mesh_, wrong, 1);
  std::vector<FaceId> all;
  std::set_union(faces_.begin(), faces_.end(), grown.begin(), grown.end(), std::back_inserter(all));
  const bool mayGrow = growth_ < rungs_[rung_].growthRounds && !wrong.empty() &&
                       program.status != socp::SolveStatus::kInfeasible;
  if (mayGrow && !isBound) patch_ = smallPatchAround(grown);
  if (mayGrow && (!patch_.empty() || (all.size() > faces_.size() && all.size() <= limit))) {
    ++growth_;
    faces_ = std::move(all);
    return;
  }
  ++rung_;
  startRung();
}

}  // namespace hgp
