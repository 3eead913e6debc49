#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "hgp/api/json/json_text.h"
#include "hgp/api/json/spliced_text.h"
#include "hgp/base/stable_order.h"
#include "hgp/verify/needed_tolerance.h"

namespace hgp::api {
namespace {

// Lists are cut off here, since longer ones are of no use; counts are always complete.
constexpr std::size_t kMaxListed = 10'000;

const char* precisionName(Precision precision) {
  return precision == Precision::kFloat32 ? "float32" : "float64";
}

/// JSON has no infinity.
double finite(double x) { return std::min(x, std::numeric_limits<double>::max()); }

/// The tolerance of a seam edge: a fraction of its own length.
double allowed(const MeasuredSeam& seam) {
  return seam.length > 0 ? seam.allowed / seam.length : 0;
}

Json thresholds(const Certificate& c) {
  return object({{"seam", c.thresholds.tolerance},
                 {"angle", c.thresholds.tolerance},
                 {"rounding", c.thresholds.rounding},
                 {"largestRounding", c.thresholds.largestRounding},
                 {"areaSpan", c.thresholds.smallestAreaSpan}});
}

Json featureCounts(const FeatureFacts& f) {
  return object({{"edges", f.edges},
                 {"straightEdges", f.straightEdges},
                 {"chains", f.chains},
                 {"straightChains", f.straightChains},
                 {"corners", f.corners}});
}

class ComponentJson {
 public:
  /// @param name  begins its reasons where there are several components, since they count in their component only
  ComponentJson(const ModelComponent& component, const Certificate& c, std::string name)
      : component_(component), c_(c), name_(std::move(name)) {}

  Json make() const {
    Json json = object(
        {{"certified", c_.isCertified}, {"usable", c_.isUsable}, {"measured", c_.isMeasured}});
    json["vertices"] = c_.vertexCount;
    json["edges"] = c_.edgeCount;
    json["triangles"] = c_.faceCount;
    json["eulerCharacteristic"] = c_.eulerCharacteristic;
    json["genus"] = c_.genus;
    json["boundaryLoops"] = c_.loopCount;
    json["orientation"] = orientation();
    json["angles"] = angles();
    json["cones"] = cones(c_.angles.cones);
    json["wrongCones"] = cones(c_.angles.wrong);
    json["turnings"] = turnings();
    json["handles"] = handles();
    json["seams"] = seams();
    if (c_.features.edges > 0) json["features"] = features();
    json["gaussBonnet"] = object({{"have", c_.gaussBonnetHave}, {"need", c_.gaussBonnetNeed}});
    json["distortion"] = distortion();
    json["overlap"] = object({{"share", c_.overlap.share}, {"layers", c_.overlap.layers}});
    json["thresholds"] = thresholds(c_);
    json["reasons"] = reasons();
    return json;
  }

 private:
  int vertex(VertexId v) const { return component_.vertex[v].i; }
  int face(FaceId f) const { return component_.face[f].i; }

  static Json listed(std::vector<int> ids) {
    std::sort(ids.begin(), ids.end());
    if (ids.size() > kMaxListed) ids.resize(kMaxListed);
    return Json(std::move(ids));
  }

  Json orientation() const {
    const OrientationFacts& o = c_.orientation;
    std::vector<int> faces;
    for (FaceId f : o.notPositive) faces.push_back(face(f));
    return object({{"positive", o.positive},
                   {"zero", o.zero},
                   {"negative", o.negative},
                   {"constrained", o.constrained},
                   {"constrainedPositive", o.constrainedPositive},
                   {"notPositive", listed(std::move(faces))}});
  }

  Json angles() const {
    const AngleFacts& a = c_.angles;
    std::vector<int> overlapping;
    for (VertexId v : a.overlapping) overlapping.push_back(vertex(v));
    return object({{"wrong", a.wrong.size()},
                   {"worstDistance", a.worstDistance},
                   {"worstVertex", vertex(a.worstVertex)},
                   {"allowed", a.allowedThere},
                   {"smallestAngle", a.smallestAngle},
                   {"overlappingBoundaryVertices", listed(std::move(overlapping))}});
  }

  Json cones(std::vector<MeasuredCone> list) const {
    sortStably(list, [&](const MeasuredCone& a, const MeasuredCone& b) {
      return vertex(a.vertex) < vertex(b.vertex);
    });
    Json out = Json::array();
    for (const MeasuredCone& m : list) {
      if (out.size() >= kMaxListed) break;
      out.push_back(object({{"vertex", vertex(m.vertex)},
                            {"asked", m.asked},
                            {"measured", m.measured},
                            {"distance", m.distance},
                            {"allowed", m.allowed}}));
    }
    return out;
  }

  Json turnings() const {
    Json out = Json::array();
    for (const MeasuredTurning& t : c_.angles.turnings) {
      out.push_back(object({{"loop", component_.loop[t.loop].i},
                            {"asked", optionalNumber(t.asked)},
                            {"measured", t.measured},
                            {"distance", t.distance},
                            {"allowed", t.allowed}}));
    }
    return out;
  }

  Json handles() const {
    Json out = Json::array();
    for (const MeasuredHandle& h : c_.seams.handles) {
      out.push_back(object({{"generator", component_.generatorOffset + h.index},
                            {"asked", optionalNumber(h.asked)},
                            {"measured", optionalNumber(h.measured)}}));
    }
    return out;
  }

  Json seams() const {
    const SeamFacts& s = c_.seams;
    const bool isExact = c_.exactSeams.isApplicable;
    Json worst = Json::array();
    if (s.worst) {
      const HalfedgeId h = component_.mesh.halfedge(s.worst->edge);
      worst = {vertex(component_.mesh.tail(h)), vertex(component_.mesh.head(h))};
    }
    return object({{"edges", s.seams.size()},
                   {"broken", s.broken.size()},
                   {"exact", isExact ? Json(c_.exactSeams.exact) : Json()},
                   {"integer", isExact ? Json(c_.exactSeams.integer) : Json()},
                   {"charts", s.chartCount},
                   {"worstResidual", s.worst ? finite(s.worst->relativeResidual()) : 0},
                   {"allowed", s.worst ? allowed(*s.worst) : 0},
                   {"worstEdge", std::move(worst)},
                   {"worstLengthResidual", s.worstLengthResidual},
                   {"largestUv", s.maxUv},
                   {"meanUvEdge", s.meanEdge}});
  }

  Json features() const {
    Json json = featureCounts(c_.features);
    Json& list = json["notStraight"] = Json::array();
    for (EdgeId e : c_.features.notStraight) {
      if (list.size() >= kMaxListed) break;
      const HalfedgeId h = component_.mesh.halfedge(e);
      list.push_back({vertex(component_.mesh.tail(h)), vertex(component_.mesh.head(h))});
    }
    return json;
  }

  Json distortion() const {
    const DistortionFacts& d = c_.distortion;
    return object({{"meanMu", d.meanMu},
                   {"medianMu", d.medianMu},
                   {"p95Mu", d.p95Mu},
                   {"maxMu", d.maxMu},
                   {"worstMuTriangle", face(d.worstMu)},
                   {"rmsLogArea", d.rmsLogArea},
                   {"p95LogArea", d.p95LogArea},
                   {"minLogArea", d.minLogArea},
                   {"maxLogArea", d.maxLogArea},
                   {"sizeSpread", d.sizeSpread},
                   {"symmetricDirichlet", d.symmetricDirichlet},
                   {"areaSpan", d.areaSpan},
                   {"smallestToMeanArea", d.smallestToMeanArea},
                   {"smallestTriangle", face(d.smallestArea)}});
  }

  Json reasons() const {
    Json out = Json::array();
    for (const Reason& own : c_.reasons) {
      const Reason reason = toSurfaceIds(component_, own);
      out.push_back(object({{"rule", ruleName(reason.rule)},
                            {"count", reason.count},
                            {"worst", finite(reason.worst)},
                            {"message", name_ + reason.message},
                            {"where", whereJson(reason.where)}}));
    }
    return out;
  }

  const ModelComponent& component_;
  const Certificate& c_;
  const std::string name_;
};

/// Of the component that overlaps itself most; components lie side by side.
Json overlapOf(const std::vector<Certificate>& certificates) {
  OverlapFacts most;
  for (const Certificate& c : certificates) {
    most.share = std::max(most.share, c.overlap.share);
    most.layers = std::max(most.layers, c.overlap.layers);
  }
  return object({{"share", most.share}, {"layers", most.layers}});
}

/// The most important numbers, over all components.
void addSummary(Json& json, const std::vector<Certificate>& certificates) {
  int triangles = 0, flipped = 0;
  std::size_t wrongAngles = 0, broken = 0, seams = 0;
  int wrongTurnings = 0, exact = 0, integer = 0;
  bool isExactApplicable = !certificates.empty();
  double coneDistance = 0, turningDistance = 0;
  const MeasuredSeam* worst = nullptr;
  FeatureFacts features;
  for (const Certificate& c : certificates) {
    triangles += c.faceCount;
    flipped += c.orientation.zero + c.orientation.negative;
    wrongAngles += c.angles.wrong.size();
    broken += c.seams.broken.size();
    seams += c.seams.seams.size();
    exact += c.exactSeams.exact;
    integer += c.exactSeams.integer;
    features.edges += c.features.edges;
    features.straightEdges += c.features.straightEdges;
    features.chains += c.features.chains;
    features.straightChains += c.features.straightChains;
    features.corners += c.features.corners;
    isExactApplicable = isExactApplicable && c.exactSeams.isApplicable;
    coneDistance = std::max(coneDistance, c.angles.worstDistance);
    for (const MeasuredTurning& t : c.angles.turnings) {
      turningDistance = std::max(turningDistance, t.distance);
      wrongTurnings += t.isWrong;
    }
    if (c.seams.worst && (!worst || isWorse(*c.seams.worst, *worst))) worst = &*c.seams.worst;
  }
  json["triangles"] = triangles;
  json["flipped"] = flipped;
  json["wrongAngles"] = wrongAngles;
  json["wrongTurnings"] = wrongTurnings;
  json["seamEdges"] = seams;
  json["brokenSeams"] = broken;
  json["exactSeams"] = isExactApplicable ? Json(exact) : Json();
  json["integerSeams"] = isExactApplicable ? Json(integer) : Json();
  if (features.edges > 0) json["features"] = featureCounts(features);
  json["maxConeDistance"] = coneDistance;
  json["maxTurningDistance"] = turningDistance;
  json["maxSeamResidual"] = worst ? finite(worst->relativeResidual()) : 0;
  json["seamTolerance"] = worst ? allowed(*worst) : 0;
  json["overlap"] = overlapOf(certificates);
  const NeededTolerance needed = neededTolerance(certificates);
  json["needed"] = object({{"seam", finite(needed.seam)},
                           {"angle", needed.angle},
                           {"sufficient", needed.isSufficient}});
}

}  // namespace

SplicedDocument certificateDocument(const Model& model,
                                    const std::vector<Certificate>& certificates,
                                    const OutsideFacts& outside, int uvSet, const Notes& notes) {
  Json json = object({{"format", "hgp-certificate"}, {"version", 1}});
  bool isUsable = !certificates.empty();
  for (const Certificate& c : certificates) isUsable = isUsable && c.isUsable;
  json["certified"] = areCertified(certificates);
  json["usable"] = isUsable;
  json["q"] = certificates.empty() ? 0 : certificates[0].q;
  json["precision"] = certificates.empty() ? "float64" : precisionName(certificates[0].precision);
  if (uvSet >= 0) json["uvSet"] = uvSet;
  addSummary(json, certificates);
  json["stored"] = object({{"triangles", outside.stored},
                           {"verified", outside.verified},
                           {"duplicates", outside.duplicates},
                           {"differing", outside.differing},
                           {"zeroArea", outside.zeroArea},
                           {"reversed", outside.reversed},
                           {"splitVertices", outside.splitVertices},
                           {"polygons", outside.polygons.polygons},
                           {"notConvex", outside.polygons.notConvex}});
  constexpr const char* kHere = "(components)";
  json["components"] = kHere;
  if (!notes.empty()) json["notes"] = notesJson(notes);
  const auto component = [&model, &certificates](std::size_t p) {
    const std::string name =
        certificates.size() > 1 ? "In component " + std::to_string(p) + ": " : std::string();
    return ComponentJson(model.components[p], certificates[p], name).make();
  };
  return {std::move(json), {arrayMember(kHere, certificates.size(), component)}};
}

std::string certificateText(const Model& model, const std::vector<Certificate>& certificates,
                            const OutsideFacts& outside, int uvSet, const Notes& notes) {
  return certificateDocument(model, certificates, outside, uvSet, notes).text();
}

}  // namespace hgp::api
