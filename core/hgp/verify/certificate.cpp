#include "hgp/verify/certificate.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <numbers>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/float32.h"
#include "hgp/base/parallel.h"
#include "hgp/verify/asked_map.h"
#include "hgp/verify/verdict.h"

namespace hgp {
namespace {

double unitRoundoff(Precision precision) {
  return precision == Precision::kFloat32 ? FLT_EPSILON : DBL_EPSILON;
}

/// uv per corner as stored, or the reasons why there are none.
struct GatheredUv {
  CornerUv uv;
  std::vector<Reason> reasons;
};

GatheredUv gatherUv(const TriMesh& mesh, const UvMap& map, const CertifyOptions& options) {
  GatheredUv out;
  const auto faceCount = static_cast<std::size_t>(mesh.faceCount());
  if (map.cornerUv.size() != faceCount) {
    out.reasons.push_back({Rule::kMalformedUv,
                           1,
                           double(map.cornerUv.size()),
                           formatText("uv indices are given for %s; the mesh has %zu.",
                                      counted(map.cornerUv.size(), "face").c_str(), faceCount),
                           {}});
    return out;
  }
  Reason outside{Rule::kMalformedUv, 0, 0.0, "", {}}, infinite{Rule::kNotFinite, 0, 0.0, "", {}};
  const auto note = [&](Reason& reason, std::size_t f) {
    if (reason.count++ < options.placesPerReason)
      reason.where.push_back({Where::Kind::kFace, static_cast<std::int64_t>(f)});
  };
  out.uv = CornerUv(3 * faceCount);
  for (std::size_t f = 0; f < faceCount; ++f) {
    bool isOutside = false, isFinite = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const int n = map.cornerUv[f][k];
      if (n < 0 || static_cast<std::size_t>(n) >= map.uv.size()) {
        isOutside = true;
        continue;
      }
      const Vec2& p = map.uv[static_cast<std::size_t>(n)];
      isFinite = isFinite && std::isfinite(p[0]) && std::isfinite(p[1]);
      out.uv[HalfedgeId(static_cast<int>(3 * f + k))] = p;
    }
    if (isOutside) note(outside, f);
    if (!isFinite) note(infinite, f);
  }
  outside.message =
      formatText("uv indices of %s are out of range.", counted(outside.count, "face").c_str());
  infinite.message =
      formatText("uv of %s are not finite.", counted(infinite.count, "face").c_str());
  for (Reason* reason : {&outside, &infinite})
    if (reason->count > 0) out.reasons.push_back(std::move(*reason));
  return out;
}

/// A power of two that scales the map to ordinary size, so that squares of lengths do not over- or underflow.
/// Scaling by it is exact, and it is 1 for ordinary maps.
double measuringScale(const CornerUv& uv) {
  const double largest = largestCoordinate(uv);
  if (largest == 0.0) return 1.0;
  const int exponent = std::ilogb(largest);
  return std::abs(exponent) < 100 ? 1.0 : std::scalbn(1.0, std::min(-exponent, 1000));
}

void toUvUnits(MeasuredSeam& seam, double scale) {
  for (double* x : {&seam.residual, &seam.lengthResidual, &seam.length, &seam.allowed}) *x /= scale;
}

void toUvUnits(SeamFacts& seams, double scale) {
  for (auto* list : {&seams.seams, &seams.broken})
    for (MeasuredSeam& s : *list) toUvUnits(s, scale);
  if (seams.worst) toUvUnits(*seams.worst, scale);
  for (double* x : {&seams.worstLengthResidual, &seams.maxUv, &seams.meanEdge}) *x /= scale;
}

void describeSurface(const TriMesh& mesh, const Topology& topology, Certificate& certificate) {
  certificate.vertexCount = mesh.vertexCount() - topology.isolatedVertexCount;
  certificate.edgeCount = mesh.edgeCount();
  certificate.faceCount = mesh.faceCount();
  certificate.componentCount = topology.componentCount;
  certificate.genus = topology.genus;
  certificate.loopCount = static_cast<int>(topology.loops.size());
  certificate.eulerCharacteristic =
      certificate.vertexCount - certificate.edgeCount + certificate.faceCount;
  certificate.gaussBonnetNeed =
      static_cast<long long>(certificate.q) *
      (2 * topology.componentCount - 2 * topology.genus - certificate.loopCount);
}

/// The distance between neighbouring floats around x.
double floatStep(double x) {
  return std::scalbn(
      1.0, std::max(x > 0.0 ? std::ilogb(x) : FLT_MIN_EXP, FLT_MIN_EXP - 1) - (FLT_MANT_DIG - 1));
}

/// @param scale  what the coordinates were multiplied by for measuring
SeamRule seamRule(const CornerUv& uv, double scale, const CertifyOptions& options) {
  SeamRule rule;
  rule.tolerance = options.tolerance > 0.0 ? options.tolerance : kTolerance;
  const double largest = largestCoordinate(uv);
  if (options.precision == Precision::kFloat32) {
    const double step =
        options.gridStep > 0.0 ? options.gridStep * scale : floatStep(largest / scale) * scale;
    // Four corners, each moved by up to half a step in u and in v.
    rule.rounding = 4.0 * step * std::numbers::sqrt2 / 2.0;
    rule.largestRounding = std::max(kLargestRounding, rule.tolerance);
  }
  rule.computing = kSeamUlps * DBL_EPSILON * largest + rule.rounding;
  return rule;
}

void measure(const TriMesh& mesh, const Topology& topology, const AskedMap& asked,
             const std::vector<DualLoop>& loops, const CornerUv& uv, const CertifyOptions& options,
             Certificate& certificate) {
  const int q = certificate.q;
  CornerUv scaled;
  const double scale = measuringScale(uv);
  if (scale != 1.0) {
    scaled = uv;
    for (Vec2& p : scaled.raw()) p = {p[0] * scale, p[1] * scale};
  }
  const CornerUv& measured = scale != 1.0 ? scaled : uv;
  const SeamRule rule = seamRule(measured, scale, options);
  certificate.thresholds = {rule.tolerance, rule.rounding / scale, rule.largestRounding,
                            unitRoundoff(options.precision)};
  SeamTurns turns;
  PerHalfedge<AngleVector> angles;
  const auto measureTriangles = [&] {
    certificate.orientation = measureOrientation(mesh, asked.angles.isCone, uv);
    certificate.distortion = (options.measuresDistortion ? measureDistortion : measureAreaSpan)(
        mesh, certificate.orientation, measured);
  };
  const auto measureEdges = [&] {
    certificate.seams = measureSeams(mesh, q, measured, rule);
    certificate.exactSeams = measureExactSeams(mesh, q, uv, certificate.seams);
    certificate.seams.handles = measureHandles(mesh, q, loops, certificate.seams);
    for (std::size_t n = 0; n < asked.handles.size(); ++n)
      certificate.seams.handles[n].asked = asked.handles[n];
    turns = seamTurns(mesh, certificate.seams, rule);
  };
  parallelInvoke(
      {measureTriangles, measureEdges, [&] { angles = computeUvAngles(mesh, measured); }});
  certificate.features = measureFeatures(mesh, asked.features, uv, angles);
  certificate.angles = measureAngles(mesh, topology, asked.angles, angles,
                                     {rule.tolerance, rule.largestRounding,
                                      std::move(turns.rounding), std::move(turns.explained)});
  certificate.gaussBonnetHave = certificate.angles.turnSum;
  certificate.isMeasured = true;
  certificate.reasons = findReasons(mesh, certificate, measured, loops, options);
  if (scale != 1.0) toUvUnits(certificate.seams, scale);
}

}  // namespace

Verifier::Verifier(const TriMesh& mesh) : mesh_(mesh), topology_(computeTopology(mesh)) {
  if (topology_.componentCount == 1 && topology_.genus > 0) generators_ = handleGenerators(mesh);
}

Certificate Verifier::certify(const HolonomySpec& asked, const UvMap& map,
                              const CertifyOptions& options) const {
  Certificate certificate;
  certificate.q = asked.q;
  certificate.precision = options.precision;
  describeSurface(mesh_, topology_, certificate);
  const AskedMap wanted =
      layOutAsked(mesh_, topology_, static_cast<int>(generators_.size()), asked, options);
  GatheredUv gathered = gatherUv(mesh_, map, options);
  if (mesh_.faceCount() == 0)
    certificate.reasons.push_back({Rule::kEmpty, 1, 0.0, "There is no triangle to verify.", {}});
  else if (gathered.reasons.empty() && asked.q >= 1)
    measure(mesh_, topology_, wanted, generators_, gathered.uv, options, certificate);
  for (auto* more :
       {&wanted.mismatches, static_cast<const std::vector<Reason>*>(&gathered.reasons)})
    certificate.reasons.insert(certificate.reasons.end(), more->begin(), more->end());
  certificate.isCertified = certificate.isMeasured && certificate.reasons.empty();
  certificate.isUsable = certificate.isMeasured &&
                         certificate.distortion.areaSpan >= certificate.thresholds.smallestAreaSpan;
  return certificate;
}

bool areCertified(const std::vector<Certificate>& components) {
  return !components.empty() && std::all_of(components.begin(), components.end(),
                                            [](const Certificate& c) { return c.isCertified; });
}

Certificate certify(const TriMesh& mesh, const HolonomySpec& asked, const UvMap& map,
                    const CertifyOptions& options) {
  return Verifier(mesh).certify(asked, map, options);
}

Certificate certify(const TriMesh& mesh, const CompleteSpec& asked, const UvMap& map,
                    const CertifyOptions& options) {
  return certify(mesh, toSpec(asked), map, options);
}

}  // namespace hgp
