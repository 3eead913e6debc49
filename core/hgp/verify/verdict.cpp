#include "hgp/verify/verdict.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/stable_order.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// A place and how bad it is there.
struct Place {
  double badness;
  Where where;
};

Where whereVertex(VertexId v) { return {Where::Kind::kVertex, v.i}; }
Where whereEdge(const TriMesh& mesh, HalfedgeId h) {
  return {Where::Kind::kEdge, mesh.tail(h).i, mesh.head(h).i};
}

/// Worst first; equally bad places by their order, so that reports do not depend on the sort.
std::vector<Where> worstPlaces(std::vector<Place> places, int limit) {
  const auto shown = std::min(places.size(), static_cast<std::size_t>(std::max(limit, 0)));
  sortStably(places, [](const Place& a, const Place& b) { return a.badness > b.badness; });
  std::vector<Where> where;
  for (std::size_t n = 0; n < shown; ++n) where.push_back(places[n].where);
  return where;
}

const char* plural(std::size_t n) { return n == 1 ? "" : "s"; }

void checkOrientation(const Certificate& facts, const CornerUv& uv, const CertifyOptions& options,
                      std::vector<Reason>& reasons) {
  const OrientationFacts& o = facts.orientation;
  if (o.notPositive.empty()) return;
  std::vector<Place> places;
  double worst = 0.0;
  for (FaceId f : o.notPositive) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    const Vec2 &a = uv[h], &b = uv[TriMesh::next(h)], &c = uv[TriMesh::previous(h)];
    const double area = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    worst = std::min(worst, area);
    places.push_back({-area, {Where::Kind::kFace, f.i}});
  }
  // Relative to an equilateral triangle of the mean edge.
  const double unit = facts.seams.meanEdge * facts.seams.meanEdge * std::sqrt(3.0) / 4.0;
  const double relative = unit > 0.0 ? worst / unit : 0.0;
  reasons.push_back(
      {Rule::kOrientation, static_cast<int>(o.notPositive.size()), relative,
       formatText(
           "%zu of %d triangles %s not positive: %d reversed, %d without area; the worst has an "
           "area of %.3g mean triangles.",
           o.notPositive.size(), facts.faceCount, o.notPositive.size() == 1 ? "is" : "are",
           o.negative, o.zero, relative),
       worstPlaces(std::move(places), options.placesPerReason)});
}

/// |angle − 2π·asked/q|, of an angle whose nearest integer is `measured`.
double offBy(const AngleDistance& angle, int measured, int asked, int q) {
  return std::fabs(turnAngle(double(measured) - asked, q) + angle.excess);
}

/// Ends the message of a reason with an id and what follows it.
void name(NamedId::Kind kind, int id, const std::string& rest, Reason& reason) {
  reason.named = NamedId{kind, id, reason.message.size()};
  reason.message += std::to_string(id) + rest;
}

/// The integer is as prescribed, and the deviation of the angle is due to the number type.
bool isOutOfRange(const MeasuredCone& c) { return c.measured == c.asked && c.isExplained; }
bool isOutOfRange(const MeasuredTurning& t) {
  return t.asked.value_or(t.measured) == t.measured && t.isExplained;
}

const char* typeName(const Certificate& facts) {
  return facts.precision == Precision::kFloat32 ? "float32" : "float64";
}

constexpr const char* kWayOut = "More cones in the region that shrinks help";

void checkConeAngles(const Certificate& facts, const CertifyOptions& options,
                     std::vector<Reason>& reasons) {
  std::vector<Place> places;
  const MeasuredCone* worst = nullptr;
  const auto error = [&](const MeasuredCone& c) { return offBy(c, c.measured, c.asked, facts.q); };
  for (const MeasuredCone& c : facts.angles.wrong) {
    if (isOutOfRange(c)) continue;
    places.push_back({error(c), whereVertex(c.vertex)});
    if (!worst || error(c) > error(*worst)) worst = &c;
  }
  if (!worst) return;
  reasons.push_back({Rule::kConeAngle, static_cast<int>(places.size()),
                     error(*worst) / turnAngle(1, facts.q),
                     formatText("%zu interior angle sum%s not as asked; worst at vertex ",
                                places.size(), places.size() == 1 ? " is" : "s are"),
                     worstPlaces(std::move(places), options.placesPerReason)});
  name(NamedId::Kind::kVertex, worst->vertex.i,
       formatText(": k = %d, asked k = %d (angle 2πk/%d), off by %.3g rad (accepted %.3g).",
                  worst->measured, worst->asked, facts.q, error(*worst), worst->allowed),
       reasons.back());
}

void checkTurnings(const Certificate& facts, const CertifyOptions& options,
                   std::vector<Reason>& reasons) {
  std::vector<Place> places;
  const MeasuredTurning* worst = nullptr;
  const auto error = [&](const MeasuredTurning& t) {
    return offBy(t, t.measured, t.asked.value_or(t.measured), facts.q);
  };
  for (const MeasuredTurning& t : facts.angles.turnings) {
    if (!t.isWrong || isOutOfRange(t)) continue;
    places.push_back({error(t), {Where::Kind::kLoop, t.loop.i}});
    if (!worst || error(t) > error(*worst)) worst = &t;
  }
  if (!worst) return;
  const std::string asked = worst->asked ? std::to_string(*worst->asked) : "an integer";
  reasons.push_back({Rule::kTurning, static_cast<int>(places.size()),
                     error(*worst) / turnAngle(1, facts.q),
                     formatText("%zu boundary loop%s not turned as asked; worst loop ",
                                places.size(), places.size() == 1 ? " is" : "s are"),
                     worstPlaces(std::move(places), options.placesPerReason)});
  name(NamedId::Kind::kLoop, worst->loop.i,
       formatText(": l = %d, asked l = %s (turning 2πl/%d), off by %.3g rad (accepted %.3g).",
                  worst->measured, asked.c_str(), facts.q, error(*worst), worst->allowed),
       reasons.back());
}

void checkSeams(const TriMesh& mesh, const Certificate& facts, const CertifyOptions& options,
                std::vector<Reason>& reasons) {
  std::vector<Place> places;
  double worst = 0.0, allowed = 0.0;
  for (const MeasuredSeam& s : facts.seams.broken) {
    if (s.isExplained) continue;
    places.push_back({s.relativeResidual(), whereEdge(mesh, mesh.halfedge(s.edge))});
    if (places.size() > 1 && s.relativeResidual() <= worst) continue;
    worst = s.relativeResidual();
    allowed = s.length > 0.0 ? s.allowed / s.length : 0.0;
  }
  if (places.empty()) return;
  reasons.push_back(
      {Rule::kSeam, static_cast<int>(places.size()), worst,
       formatText("%zu of %zu seam edge%s not related by a rotation by a multiple of 2π/%d; the "
                  "worst is off by %.3g of its own length, accepted %.3g.",
                  places.size(), facts.seams.seams.size(), places.size() == 1 ? " is" : "s are",
                  facts.q, worst, allowed),
       worstPlaces(std::move(places), options.placesPerReason)});
}

/// Deviations of seams and angles that are due to the number type.
void checkCoordinates(const TriMesh& mesh, const Certificate& facts, const CertifyOptions& options,
                      std::vector<Reason>& reasons) {
  std::vector<Place> places;
  double worst = 0.0;
  std::size_t edges = 0, sums = 0;
  const auto note = [&](double error, const Where& where) {
    places.push_back({error, where});
    worst = std::max(worst, error);
  };
  for (const MeasuredSeam& s : facts.seams.broken)
    if (s.isExplained && ++edges)
      note(s.relativeResidual(), whereEdge(mesh, mesh.halfedge(s.edge)));
  for (const MeasuredCone& c : facts.angles.wrong)
    if (isOutOfRange(c) && ++sums) note(c.distance, whereVertex(c.vertex));
  for (const MeasuredTurning& t : facts.angles.turnings)
    if (t.isWrong && isOutOfRange(t) && ++sums) note(t.distance, {Where::Kind::kLoop, t.loop.i});
  if (places.empty()) return;
  reasons.push_back(
      {Rule::kRange, static_cast<int>(places.size()), worst,
       formatText("The range of the map is beyond %s: with coordinates up to %.3g, %zu seam "
                  "edge%s and %zu angle sum%s cannot be stored to %.3g of their own size; "
                  "the worst is off by %.3g. %s.",
                  typeName(facts), facts.seams.maxUv, edges, plural(edges), sums, plural(sums),
                  std::max(facts.thresholds.tolerance, facts.thresholds.largestRounding), worst,
                  kWayOut),
       worstPlaces(std::move(places), options.placesPerReason)});
}

void checkAreas(const Certificate& facts, std::vector<Reason>& reasons) {
  const DistortionFacts& d = facts.distortion;
  // Areas of other signs have been refused; without any there is nothing to compare.
  if (d.triangleCount == 0 || d.areaSpan >= facts.thresholds.smallestAreaSpan) return;
  reasons.push_back(
      {Rule::kRange,
       1,
       d.areaSpan,
       formatText("The range of the map is beyond %s: the smallest area scale is %.3g of the mean, "
                  "needed is %.3g. %s.",
                  typeName(facts), d.areaSpan, facts.thresholds.smallestAreaSpan, kWayOut),
       {{Where::Kind::kFace, d.smallestArea.i}}});
}

void checkHandles(const TriMesh& mesh, const Certificate& facts, const std::vector<DualLoop>& loops,
                  const CertifyOptions& options, std::vector<Reason>& reasons) {
  Reason reason{Rule::kHandle, 0, 0.0, "", {}};
  const MeasuredHandle* first = nullptr;
  for (const MeasuredHandle& h : facts.seams.handles) {
    if (!h.asked || h.asked == h.measured) continue;
    if (reason.count++ > 0) continue;
    first = &h;
    reason.worst = h.measured ? *h.measured : -1;
    for (HalfedgeId c : loops[static_cast<std::size_t>(h.index)].crossed)
      if (static_cast<int>(reason.where.size()) < options.placesPerReason)
        reason.where.push_back(whereEdge(mesh, c));
  }
  if (!first) return;
  const std::string measured = first->measured ? std::to_string(*first->measured) : "no rotation";
  reason.message = formatText("%d handle%s not rotated as asked; first is handle ", reason.count,
                              reason.count == 1 ? " is" : "s are");
  name(NamedId::Kind::kHandle, first->index,
       formatText(": measured %s, asked %d (of %d).", measured.c_str(), *first->asked, facts.q),
       reason);
  reasons.push_back(std::move(reason));
}

void checkFeatures(const TriMesh& mesh, const Certificate& facts, const CertifyOptions& options,
                   std::vector<Reason>& reasons) {
  const FeatureFacts& f = facts.features;
  if (f.notStraight.empty()) return;
  Reason reason{Rule::kFeature,
                static_cast<int>(f.notStraight.size()),
                double(f.notStraight.size()),
                formatText("%zu of %d feature edges %s not straight: neither u nor v is the same "
                           "number at both ends.",
                           f.notStraight.size(), f.edges, f.notStraight.size() == 1 ? "is" : "are"),
                {}};
  for (EdgeId e : f.notStraight)
    if (static_cast<int>(reason.where.size()) < options.placesPerReason)
      reason.where.push_back(whereEdge(mesh, mesh.halfedge(e)));
  reasons.push_back(std::move(reason));
}

void checkIntegers(const Certificate& facts, std::vector<Reason>& reasons) {
  if (facts.gaussBonnetHave != facts.gaussBonnetNeed)
    reasons.push_back(
        {Rule::kGaussBonnet,
         1,
         double(facts.gaussBonnetHave - facts.gaussBonnetNeed),
         formatText(
             "Gauss–Bonnet (Lemma 6.2) fails for the measured integers: Σ = %lld, need %lld.",
             facts.gaussBonnetHave, facts.gaussBonnetNeed),
         {}});
  const int expected = 2 * facts.componentCount - 2 * facts.genus - facts.loopCount;
  if (facts.eulerCharacteristic != expected)
    reasons.push_back(
        {Rule::kEuler,
         1,
         double(facts.eulerCharacteristic - expected),
         formatText("V − E + F = %d, but 2c − 2g − m = %d.", facts.eulerCharacteristic, expected),
         {}});
}

}  // namespace

std::vector<Reason> findReasons(const TriMesh& mesh, const Certificate& facts, const CornerUv& uv,
                                const std::vector<DualLoop>& loops, const CertifyOptions& options) {
  std::vector<Reason> reasons;
  checkOrientation(facts, uv, options, reasons);
  checkConeAngles(facts, options, reasons);
  checkTurnings(facts, options, reasons);
  checkSeams(mesh, facts, options, reasons);
  checkHandles(mesh, facts, loops, options, reasons);
  checkFeatures(mesh, facts, options, reasons);
  checkIntegers(facts, reasons);
  checkCoordinates(mesh, facts, options, reasons);
  checkAreas(facts, reasons);
  return reasons;
}

}  // namespace hgp
