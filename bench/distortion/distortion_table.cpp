#include "distortion_table.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "hgp/base/check.h"

namespace hgp::bench {
namespace {

using Json = nlohmann::json;

// Calls visit(name, member) for every column: one list for writing and reading.
template <class Map, class Visit>
void eachMapColumn(Map& m, const Visit& visit) {
  visit("map", m.name);
  visit("cones", m.cones);
  visit("certified", m.isCertified);
  visit("flipped", m.flipped);
  visit("meanMu", m.meanMu);
  visit("p95Mu", m.p95Mu);
  visit("sigma", m.sigma);
  visit("excess", m.excess);
  visit("steps", m.steps);
  visit("seconds", m.seconds);
  visit("note", m.note);
}
template <class Row, class Visit>
void eachRowColumn(Row& r, const Visit& visit) {
  visit("name", r.name);
  visit("failure", r.failure);
  visit("triangles", r.triangles);
  visit("genus", r.genus);
  visit("boundaryLoops", r.loops);
  visit("q", r.q);
}

Json asJson(const DistortionRow& row) {
  Json out;
  eachRowColumn(row, [&](const char* name, const auto& member) { out[name] = member; });
  Json& maps = out["maps"] = Json::array();
  for (const MeasuredMap& map : row.maps) {
    Json& one = maps.emplace_back();
    eachMapColumn(map, [&](const char* name, const auto& member) { one[name] = member; });
  }
  return out;
}

/// Ratios of one number of two maps, over all surfaces that have both and where the base is worth it.
class Ratios {
 public:
  using Number = std::function<double(const MeasuredMap&)>;

  Ratios(const std::vector<DistortionRow>& rows, const char* of, const char* to,
         const Number& number, const Number& base) {
    for (const DistortionRow& row : rows) {
      const MeasuredMap *a = row.find(of), *b = row.find(to);
      const MeasuredMap* plain = row.maps.empty() ? nullptr : &row.maps.front();
      if (!a || !b || !plain->isCertified || plain->excess < kMeasurableExcess) continue;
      if (a->note == "time limit" || b->note == "time limit") continue;
      if (base(*b) > 0.0) values_.push_back(number(*a) / base(*b));
    }
    std::sort(values_.begin(), values_.end());
  }

  double at(double share) const {
    return values_[static_cast<std::size_t>(share * static_cast<double>(values_.size() - 1))];
  }
  std::string cells(const std::string& label) const {
    if (values_.empty()) return "| " + label + " | 0 | | | | | |\n";
    return formatText("| %s | %zu | %.3f | %.3f | **%.3f** | %.3f | %.3f |\n", label.c_str(),
                      values_.size(), values_.front(), at(0.25), at(0.5), at(0.75), values_.back());
  }

 private:
  std::vector<double> values_;
};

double excessOf(const MeasuredMap& m) { return m.excess; }
double energyOf(const MeasuredMap& m) { return 4.0 + m.excess; }
double muOf(const MeasuredMap& m) { return m.meanMu; }
double sigmaOf(const MeasuredMap& m) { return m.sigma; }
double secondsOf(const MeasuredMap& m) { return m.seconds; }

std::string summaryHead() {
  return "| ratio | surfaces | least | 25 % | median | 75 % | most |\n"
         "|---|--:|--:|--:|--:|--:|--:|\n";
}

}  // namespace

std::string distortionHead() {
  return "| surface | F | g | loops | q | map | cones | μ mean | μ 95 % | σ log₂ area | sym. "
         "Dirichlet − 4 | flips | steps | s |\n"
         "|---|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string distortionLines(const DistortionRow& row) {
  const std::string start = formatText("| %s | %d | %d | %d | %d |", row.name.c_str(),
                                       row.triangles, row.genus, row.loops, row.q);
  std::string lines;
  for (const MeasuredMap& m : row.maps) {
    lines +=
        (lines.empty() ? start : "| | | | | |") +
        formatText(" %s | %d | %.4f | %.4f | %.3f | %.4f | %d | %d | %.2f |\n", m.name.c_str(),
                   m.cones, m.meanMu, m.p95Mu, m.sigma, m.excess, m.flipped, m.steps, m.seconds);
  }
  if (!row.failure.empty()) lines += start + " " + row.failure + " | | | | | | | | |\n";
  return lines;
}

std::string improvementSummary(const std::vector<DistortionRow>& rows) {
  const auto ratio = [&](const char* label, const char* of, const char* to,
                         const Ratios::Number& number) {
    return Ratios(rows, of, to, number, number).cells(label);
  };
  std::string text = summaryHead();
  text += ratio("excess, isometric to plain", kIsometric, kPlain, excessOf);
  text += ratio("energy, isometric to free SLIM", kIsometric, kFreeSlim, energyOf);
  text += ratio("excess, isometric to free SLIM", kIsometric, kFreeSlim, excessOf);
  text += ratio("excess, isometric to SLIM with seams held", kIsometric, kSeamlessSlim, excessOf);
  text += ratio("σ, isometric to plain", kIsometric, kPlain, sigmaOf);
  text += ratio("mean μ, conformal to plain", kConformal, kPlain, muOf);
  text += ratio("mean μ, LSCM to plain", kLscm, kPlain, muOf);
  text += ratio("mean μ, conformal to LSCM", kConformal, kLscm, muOf);
  const auto whole = [](const MeasuredMap& m) { return m.seconds; };
  text += Ratios(rows, kIsometric, kPlain, whole, secondsOf)
              .cells("seconds that isometric adds, to plain");
  text += Ratios(rows, kConformal, kPlain, whole, secondsOf)
              .cells("seconds that conformal adds, to plain");
  text += ratio("seconds, SLIM with seams held to isometric", kSeamlessSlim, kIsometric, secondsOf);
  return text;
}

std::string coneSummary(const std::vector<DistortionRow>& rows) {
  std::string text = summaryHead();
  const auto conesOf = [](const MeasuredMap& m) { return static_cast<double>(m.cones); };
  for (const char* choice : {"balanced", "few", "low-distortion", kFieldCount}) {
    const auto ratio = [&](const char* label, const Ratios::Number& number) {
      const std::string name = std::string(label) + ", " + choice + " to field";
      return Ratios(rows, choice, kFieldCones, number, number).cells(name);
    };
    text += ratio("cones", conesOf) + ratio("σ", sigmaOf) + ratio("mean μ", muOf) +
            ratio("excess", excessOf) + ratio("seconds", secondsOf);
  }
  return text;
}

std::string toJson(const DistortionRow& row) {
  return asJson(row).dump(-1, ' ', false, Json::error_handler_t::replace);
}

DistortionRow distortionRowFromJson(const std::string& text) {
  const Json in = Json::parse(text);
  const auto read = [](const Json& from) {
    return [&from](const char* name, auto& member) { from.at(name).get_to(member); };
  };
  DistortionRow row;
  eachRowColumn(row, read(in));
  for (const Json& one : in.at("maps")) eachMapColumn(row.maps.emplace_back(), read(one));
  return row;
}

std::string toJson(const std::vector<DistortionRow>& rows) {
  Json out{{"format", "hgp-distortion"}, {"version", 1}};
  Json& list = out["surfaces"] = Json::array();
  for (const DistortionRow& row : rows) list.push_back(asJson(row));
  return out.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace hgp::bench
