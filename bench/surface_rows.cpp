#include "surface_rows.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "row_columns.h"

namespace hgp::bench {
namespace {

using Json = nlohmann::json;

constexpr auto eachMapColumn = [](auto& m, const auto& visit) {
  visit("map", m.name);
  visit("verdict", m.verdict);
  visit("cones", m.cones);
  visit("certified", m.isCertified);
  visit("flipped", m.flipped);
  visit("wrongAngles", m.wrongAngles);
  visit("meanMu", m.meanMu);
  visit("p95Mu", m.p95Mu);
  visit("sigma", m.sigma);
  visit("excess", m.excess);
  visit("steps", m.steps);
  visit("seconds", m.seconds);
  visit("note", m.note);
};
constexpr auto eachRowColumn = [](auto& r, const auto& visit) {
  visit("name", r.name);
  visit("failure", r.failure);
  visit("choice", r.choice);
  visit("triangles", r.triangles);
  visit("genus", r.genus);
  visit("boundaryLoops", r.loops);
  visit("q", r.q);
};

Json asJson(const SurfaceRow& row) {
  Json out = columnsOf(row, eachRowColumn);
  Json& maps = out["maps"] = Json::array();
  for (const MeasuredMap& map : row.maps) maps.push_back(columnsOf(map, eachMapColumn));
  return out;
}

int wrongAngles(const Certificate& certificate) {
  const auto& turnings = certificate.angles.turnings;
  return static_cast<int>(
      certificate.angles.wrong.size() +
      static_cast<std::size_t>(std::count_if(turnings.begin(), turnings.end(),
                                             [](const MeasuredTurning& t) { return t.isWrong; })));
}

int flippedTriangles(const Certificate& certificate) {
  return certificate.orientation.zero + certificate.orientation.negative;
}

}  // namespace

const MeasuredMap* SurfaceRow::find(const std::string& map) const {
  const auto found =
      std::find_if(maps.begin(), maps.end(), [&](const MeasuredMap& m) { return m.name == map; });
  return found == maps.end() ? nullptr : &*found;
}

std::string verdictOf(const Certificate& certificate) {
  if (certificate.isCertified) return "certified";
  if (!certificate.isMeasured) return "no map";
  const int flipped = flippedTriangles(certificate), angles = wrongAngles(certificate);
  if (flipped > 0 && angles > 0) return formatText("%d flipped, %d angles", flipped, angles);
  if (flipped > 0) return formatText("%d flipped", flipped);
  if (angles > 0) return formatText("%d angles", angles);
  const auto breaks = [&](Rule rule) {
    return std::any_of(certificate.reasons.begin(), certificate.reasons.end(),
                       [&](const Reason& reason) { return reason.rule == rule; });
  };
  if (breaks(Rule::kSeam) || breaks(Rule::kHandle)) return "seams open";
  return breaks(Rule::kRange) ? "beyond float64" : "not certified";
}

MeasuredMap measured(const std::string& name, const Certificate& certificate) {
  MeasuredMap map;
  map.name = name;
  map.verdict = verdictOf(certificate);
  map.isCertified = certificate.isCertified;
  map.flipped = flippedTriangles(certificate);
  map.wrongAngles = wrongAngles(certificate);
  map.meanMu = certificate.distortion.meanMu;
  map.p95Mu = certificate.distortion.p95Mu;
  map.sigma = certificate.distortion.rmsLogArea;
  map.excess = certificate.distortion.symmetricDirichlet;
  return map;
}

std::string toJson(const SurfaceRow& row) {
  return asJson(row).dump(-1, ' ', false, Json::error_handler_t::replace);
}

SurfaceRow surfaceRowFromJson(const std::string& text) {
  const Json in = Json::parse(text);
  SurfaceRow row;
  readColumns(in, row, eachRowColumn);
  for (const Json& one : in.at("maps")) readColumns(one, row.maps.emplace_back(), eachMapColumn);
  return row;
}

std::string toJson(const std::vector<SurfaceRow>& rows, const char* format) {
  Json out{{"format", format}, {"version", 1}};
  Json& list = out["surfaces"] = Json::array();
  for (const SurfaceRow& row : rows) list.push_back(asJson(row));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hgp::bench
