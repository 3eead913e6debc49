#include "text_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "hgp/api/notes.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "short_document.h"

namespace hgp::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxLines = 8;

std::string text(const Json& value) {
  return printable(value.is_string() ? value.get<std::string>() : value.dump());
}

long long integer(const Json& json, const char* key) {
  const auto it = json.find(key);
  return it != json.end() && it->is_number() ? it->get<long long>() : 0;
}

double number(const Json& json, const char* key) {
  const auto it = json.find(key);
  return it != json.end() && it->is_number() ? it->get<double>() : 0;
}

std::string row(const char* label, const std::string& value) {
  return formatText("  %-20s %s\n", label, value.c_str());
}

/// A note of a document as a sentence.
std::string sentence(const Json& note) { return printable(api::phraseJson(note.dump())); }

/// An error of a document with its advice.
std::string toldText(const Json& failure) {
  std::string out = text(failure["message"]);
  const Json advice = failure.value("advice", Json::array());
  if (advice.empty()) return out;
  if (!out.empty() && out.back() == '.') out.pop_back();
  for (const Json& note : advice) out += ". " + sentence(note);
  return out + ".";
}

std::string notes(const Json& json) {
  std::string out;
  const auto it = json.find("notes");
  if (it == json.end()) return out;
  for (const Json& note : *it) out += "  note: " + sentence(note) + "\n";
  return out;
}

std::string places(const Json& where) {
  std::string out;
  for (std::size_t i = 0; i < where.size() && i < kMaxLines; ++i) {
    const Json& w = where[i];
    out += i == 0 ? " (" : ", ";
    out += text(w["kind"]) + " " + w["id"].dump();
    if (w.contains("other")) out += "–" + w["other"].dump();
  }
  if (where.size() > kMaxLines) out += ", …";
  return out.empty() ? out : out + ")";
}

std::string error(const Json& json) {
  const auto it = json.find("error");
  return it == json.end() ? "" : "  " + toldText(*it) + "\n";
}

std::string measured(const Json& c, const Style& style) {
  std::string out;
  std::size_t notMeasured = 0;
  long long triangles = 0;  // of components that were measured
  for (const Json& component : c["components"]) {
    const bool isMeasured = component["measured"].get<bool>();
    if (isMeasured) triangles += integer(component, "triangles");
    notMeasured += !isMeasured;
  }
  const long long flipped = integer(c, "flipped");
  const auto mark = [&](bool isGood) { return isGood ? style.good("ok ") : style.bad("no "); };
  const auto line = [&](bool isGood, const char* label, const std::string& value) {
    out += formatText("  %s %-20s %s\n", mark(isGood).c_str(), label, value.c_str());
  };
  if (notMeasured > 0)
    line(false, "measured",
         formatText("%zu of %zu components", c["components"].size() - notMeasured,
                    c["components"].size()));
  if (notMeasured == c["components"].size()) return out;
  line(flipped == 0, "positive triangles",
       formatText("%lld of %lld", triangles - flipped, triangles));
  line(integer(c, "wrongAngles") == 0, "angle sums",
       formatText("%lld wrong, the worst is off by %.2g rad", integer(c, "wrongAngles"),
                  number(c, "maxConeDistance")));
  line(integer(c, "wrongTurnings") == 0, "boundary turning",
       formatText("%lld wrong, the worst is off by %.2g rad", integer(c, "wrongTurnings"),
                  number(c, "maxTurningDistance")));
  line(integer(c, "brokenSeams") == 0, "seam rotations",
       formatText(
           "%lld of %lld edges broken, the worst is off by %.2g of its length (accepted %.2g)",
           integer(c, "brokenSeams"), integer(c, "seamEdges"), number(c, "maxSeamResidual"),
           number(c, "seamTolerance")));
  const long long seams = integer(c, "seamEdges");
  if (!c["exactSeams"].is_null() && seams > 0) {
    const long long exact = integer(c, "exactSeams"), whole = integer(c, "integerSeams");
    const std::string value =
        formatText("%lld of %lld, %s%s", exact, seams,
                   integer(c, "q") % 3 == 0 ? "as points of a triangular lattice" : "bit for bit",
                   whole == seams ? "; integer translations: unit grids meet" : "");
    // Listed only if all seams are exact, because a certified map need not have exact seams.
    if (exact == seams) line(true, "exact seams", value);
    if (exact != seams) out += formatText("  --  %-20s %s\n", "exact seams", value.c_str());
  }
  if (c.contains("features")) {
    const Json& f = c["features"];
    const long long chains = integer(f, "chains"), straight = integer(f, "straightChains");
    line(chains == straight, "features",
         formatText("%lld of %lld chains straight, exactly; %lld edges, %lld corners", straight,
                    chains, integer(f, "edges"), integer(f, "corners")));
  }
  return out;
}

std::string gridText(const Json& grid) {
  const std::size_t tried = grid["attempts"].size();
  if (!grid["aligned"].get<bool>()) return "not aligned: " + sentence(grid["reason"]);
  return formatText("%.0f cells, %.1f per cone, spacing %.4g; %lld integers, %s%s",
                    number(grid, "cells"), number(grid, "cellsPerCone"), number(grid, "spacing"),
                    integer(grid, "integers"), text(grid["attempts"].back()["method"]).c_str(),
                    tried > 1 ? formatText(" after %zu attempts", tried).c_str() : "");
}

std::string distortion(const Json& component) {
  const Json& d = component["distortion"];
  const double mu = number(d, "medianMu");
  return formatText(
      "stretch typically %.3g %%, size varies × %.2f (5–95 %%); "
      "μ mean %.4f, 95%% %.4f, max %.4f; log₂ area rms %.3f (%.2f … %.2f)",
      200 * mu / (1 - mu), number(d, "sizeSpread"), number(d, "meanMu"), number(d, "p95Mu"),
      number(d, "maxMu"), number(d, "rmsLogArea"), number(d, "minLogArea"),
      number(d, "maxLogArea"));
}

/// Text on stored triangles that the certificate does not cover as stored, and on polygons of which it covers hgp's
/// triangles only; empty if there are none.
std::string outside(const Json& stored) {
  std::string list;
  const auto add = [&](const char* key, const char* text) {
    if (const long long n = integer(stored, key))
      list += (list.empty() ? "" : ", ") + formatText("%lld %s", n, text);
  };
  add("duplicates", "duplicated, with the uv of the verified copy");
  if (integer(stored, "differing") > 0)
    list += formatText(" but for %lld", integer(stored, "differing"));
  add("zeroArea", "without area");
  add("reversed", "verified with the opposite winding");
  std::string out;
  if (!list.empty())
    out = row("outside", formatText("of %lld stored triangles %s", integer(stored, "triangles"),
                                    list.c_str()));
  if (const long long n = integer(stored, "notConvex"))
    out += row("polygons", formatText("%lld of %lld not convex in the map: a reader that cuts them "
                                      "along other diagonals than hgp may see flipped triangles",
                                      n, integer(stored, "polygons")));
  return out;
}

std::string certificate(const Json& json, const Style& style, std::size_t untold) {
  std::string out;
  out += notes(json) + measured(json, style) + outside(json["stored"]);
  const std::size_t count = json["components"].size() + untold;
  for (const Json& c : json["components"]) {
    const bool isMeasured = c["measured"].get<bool>();
    out += row(count > 1 ? ("component " + c["number"].dump()).c_str() : "distortion",
               isMeasured ? distortion(c) : "not measured");
    if (isMeasured) out += row("cones", formatText("%zu measured", c["cones"].size()));
    const Json& overlap = c["overlap"];
    if (integer(overlap, "layers") > 1) {
      out += row("overlap",
                 formatText("%.1f %% of the covered area, up to %lld triangles deep (allowed)",
                            100 * number(overlap, "share"), integer(overlap, "layers")));
    }
    for (const Json& reason : c["reasons"]) {
      out += "  " + style.bad(text(reason["rule"])) + ": " + text(reason["message"]) +
             places(reason["where"]) + "\n";
    }
  }
  if (untold > 0)
    out += formatText("  … and %s, all as asked\n", counted(untold, "more component").c_str());
  const bool isCertified = json["certified"].get<bool>();
  out += isCertified ? style.good("certified") : style.bad("not certified");
  out += formatText(" (q = %lld, %s%s)", integer(json, "q"), text(json["precision"]).c_str(),
                    json.contains("uvSet") ? (", uv set " + json["uvSet"].dump()).c_str() : "");
  const Json& needed = json["needed"];
  if (!isCertified && needed["sufficient"].get<bool>()) {
    const double seam = number(needed, "seam"), angle = number(needed, "angle");
    out += formatText(
        "\n  would be certified with --tol %.2g (seams need %.2g of their length, angles %.2g rad)",
        std::max(seam, angle) * 1.01, seam, angle);
  }
  return out + "\n";
}

std::string descentText(const char* title, const Json& descent) {
  const Json &before = descent["before"], &after = descent["after"];
  return row(
      title,
      formatText("%s after %zu steps%s; symmetric Dirichlet %.3g → %.3g, μ %.4f → %.4f, log₂ "
                 "area rms %.3f → %.3f",
                 text(descent["outcome"]).c_str(), descent["steps"].size(),
                 descent["kept"].get<bool>() ? "" : ", not kept",
                 number(before, "symmetricDirichlet"), number(after, "symmetricDirichlet"),
                 number(before, "meanMu"), number(after, "meanMu"), number(before, "rmsLogArea"),
                 number(after, "rmsLogArea")));
}

}  // namespace

std::string printable(const std::string& raw) {
  std::string out;
  for (char c : raw) {
    const unsigned char u = static_cast<unsigned char>(c);
    out += u < 0x20 || u == 0x7f ? '?' : c;
  }
  return out;
}

std::string Style::good(const std::string& t) const {
  return isColored ? "\033[32m" + t + "\033[0m" : t;
}
std::string Style::bad(const std::string& t) const {
  return isColored ? "\033[31m" + t + "\033[0m" : t;
}
std::string Style::strong(const std::string& t) const {
  return isColored ? "\033[1m" + t + "\033[0m" : t;
}

std::string inspectText(const std::string& source, const Style& style) {
  const Json json = Json::parse(source);
  const bool isUsable = json["usable"].get<bool>();
  std::string out = style.strong(text(json["file"]["name"])) + "  " + text(json["file"]["format"]) +
                    ", " + counted(integer(json["file"], "bytes"), "byte") + "\n";
  for (const Json& s : json["surfaces"]) {
    std::string sets = s["uvSets"].empty() ? "no uv" : "uv sets " + s["uvSets"].dump();
    out += row(("mesh " + s["index"].dump() + (s["index"] == json["surface"] ? " *" : "")).c_str(),
               text(s["name"]) + (text(s["name"]).empty() ? "" : ": ") +
                   formatText("%lld stored vertices", integer(s, "storedVertices")) + ", " +
                   counted(integer(s, "triangles"), "triangle") + ", " + sets);
    out += notes(s);
  }
  out += row("vertices", json["vertices"].dump());
  out += row("triangles", json["triangles"].dump());
  if (isUsable) {
    out += row("components", formatText("%zu", json["components"].size()));
    out += row("Euler characteristic", json["eulerCharacteristic"].dump());
    out += row("genus", json["genus"].dump());
    out += row("boundary loops", json["boundaryLoops"].dump());
    const Json& features = json["features"];
    out += row("creases", counted(integer(features, "creaseEdges"), "edge") +
                              formatText(" above %g°, in ", number(features, "degrees")) +
                              counted(integer(features, "creaseChains"), "chain"));
    for (const Json& m : json["mirrors"])
      out += row("mirror plane",
                 (m["name"] == "" ? m["normal"].dump() : text(m["name"])) +
                     formatText(" = %.6g, %lld edges in it, %lld across", number(m, "offset"),
                                integer(m, "edgesIn"), integer(m, "edgesAcross")));
    for (const Json& component : json["components"]) {
      for (const Json& loop : component["boundaryLoops"]) {
        out += row(("loop " + loop["loop"].dump()).c_str(),
                   formatText("%lld vertices, length %.6g, turns by %.1f°",
                              integer(loop, "vertices"), number(loop, "length"),
                              number(loop, "turningAngle") * 180 / 3.14159265358979));
      }
    }
  }
  for (const Json& defect : json["defects"]) {
    out += row(defect["fatal"].get<bool>() ? "defect" : "warning",
               text(defect["kind"]) + ": " + defect["count"].dump() + places(defect["where"]));
  }
  out += notes(json) + error(json);
  return out + (isUsable ? style.good("usable") : style.bad("not usable as it is")) + "\n";
}

std::string checkText(const std::string& source, const Style& style) {
  const Json json = Json::parse(source);
  std::string out;
  for (const Json& c : json["components"]) {
    const Json& budget = c["budget"];
    std::string line =
        c.contains("error") ? "refused: " + toldText(c["error"])
        : budget.is_null()
            ? std::string(c["automatic"] ? "cones are chosen automatically" : "along features")
            : formatText(
                  "Σ(q − k) + Σl = %lld, need %lld (q = %lld, genus %lld, "
                  "%lld loops); %lld cones, %lld loops open",
                  integer(budget, "have"), integer(budget, "need"), integer(json, "q"),
                  integer(c, "genus"), integer(c, "boundaryLoops"), integer(c, "cones"),
                  integer(budget, "openLoops"));
    out += row(("component " + c["component"].dump()).c_str(), line);
    for (const Json& warning : c["warnings"]) out += "  warning: " + sentence(warning) + "\n";
  }
  out += notes(json) + error(json);
  const bool isValid = json["valid"].get<bool>();
  return out + (isValid ? style.good("valid") : style.bad("no map can have this")) + "\n";
}

std::string certificateText(const std::string& source, const Style& style) {
  const ShortDocument document(source);
  return certificate(document.json, style, document.untold);
}

std::string reportText(const std::string& source, const Style& style) {
  const ShortDocument document(source);
  const Json& json = document.json;
  std::string out = style.strong(text(json["input"]["name"])) +
                    formatText("  %s, %s of q = %lld, %.2f s\n",
                               counted(integer(json["input"], "triangles"), "triangle").c_str(),
                               counted(document.cones, "cone").c_str(), integer(json["cones"], "q"),
                               number(json, "seconds"));
  for (const Json& component : json["components"]) {
    for (const Json& round : component["rounds"]) {
      out += row("round",
                 formatText("%s: %s, %s, %lld flipped, %s, %.2f s", text(round["method"]).c_str(),
                            text(round["solverStatus"]).c_str(),
                            counted(integer(round, "iterations"), "iteration").c_str(),
                            integer(round, "flipped"),
                            counted(integer(round, "wrongAngles"), "wrong angle").c_str(),
                            number(round, "seconds")));
    }
    const Json& improvement = component["improvement"];
    if (improvement.is_object()) out += descentText("improve", improvement);
    out += notes(component);
    if (const Json& grid = component["grid"]; !grid.is_null()) {
      out += row("grid", gridText(grid));
    }
    if (improvement.is_object() && improvement["onGrid"].is_object())
      out += descentText("improve on grid", improvement["onGrid"]);
    if (!component["conflict"].empty()) {
      out += "  frames strained most:" + places(component["conflict"]) + "\n";
    }
  }
  return out + notes(json) + certificate(json["certificate"], style, document.untold);
}

}  // namespace hgp::cli
