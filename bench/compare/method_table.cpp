#include "method_table.h"

#include <algorithm>
#include <iterator>

#include "hgp/base/check.h"
#include "hgp/parametrize/method.h"
#include "methods.h"
#include "ratios.h"

namespace hgp::bench {
namespace {

/// Distinct names in the order of their first occurrence.
template <class Name>
std::vector<std::string> distinct(const std::vector<SurfaceRow>& rows, const Name& nameOf) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  for (const SurfaceRow& row : rows) nameOf(row, add);
  return names;
}

std::vector<std::string> methodsOf(const std::vector<SurfaceRow>& rows) {
  return distinct(rows, [](const SurfaceRow& row, const auto& add) {
    for (const MeasuredMap& map : row.maps) add(map.name);
  });
}

/// "12/14 (+2)": certified of attempted maps, and maps without flips and with the prescribed cones but with open seams.
std::string certifiedOf(const std::vector<SurfaceRow>& rows, const std::string& method,
                        const std::string& choice, bool hasHandles) {
  int certified = 0, tried = 0, open = 0;
  for (const SurfaceRow& row : rows) {
    const MeasuredMap* map = row.find(method);
    if (!map || row.choice != choice || (row.genus > 0) != hasHandles) continue;
    ++tried;
    certified += map->isCertified;
    open += map->verdict == "seams open";
  }
  if (tried == 0) return "";
  return formatText("%d/%d", certified, tried) + (open > 0 ? formatText(" (+%d)", open) : "");
}

std::string successTable(const std::vector<SurfaceRow>& rows) {
  const std::vector<std::string> choices =
      distinct(rows, [](const SurfaceRow& row, const auto& add) { add(row.choice); });
  std::string head = "| method", rule = "|---|";
  for (const std::string& choice : choices) {
    head += " | " + choice + ", genus 0 | handles";
    rule += "--:|--:|";
  }
  std::string table = head + " |\n" + rule + "\n";
  for (const std::string& method : methodsOf(rows)) {
    table += "| " + method;
    for (const std::string& choice : choices)
      for (const bool hasHandles : {false, true})
        table += " | " + certifiedOf(rows, method, choice, hasHandles);
    table += " |\n";
  }
  return table;
}

/// The rows with automatic cones, or all others.
std::vector<SurfaceRow> rowsWith(bool areAutomatic, const std::vector<SurfaceRow>& rows) {
  std::vector<SurfaceRow> part;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(part),
               [&](const SurfaceRow& row) { return (row.choice == "balanced") == areAutomatic; });
  return part;
}

std::string ratioTable(const std::vector<SurfaceRow>& rows) {
  const std::string ours = methodName(Method::kAuto);
  const auto bothCertified = [](const SurfaceRow&, const MeasuredMap& a, const MeasuredMap& b) {
    return a.isCertified && b.isCertified;
  };
  const auto areWhole = [](const SurfaceRow&, const MeasuredMap& a, const MeasuredMap& b) {
    return a.note != "time limit" && b.isCertified;
  };
  std::string table = ratioHead();
  for (const std::string& method : methodsOf(rows)) {
    if (method == ours) continue;
    const std::string end = formatText(", %s to %s", method.c_str(), ours.c_str());
    table += Ratios(rows, method, ours, muOf, bothCertified).cells("mean μ" + end);
    table += Ratios(rows, method, ours, excessOf, bothCertified).cells("excess" + end);
    table += Ratios(rows, method, ours, secondsOf, areWhole).cells("seconds" + end);
  }
  return table;
}

}  // namespace

std::string methodHead() {
  return "| surface | F | g | loops | cones | q | method | verdict | rounds | μ mean | μ 95 % | σ "
         "log₂ area | sym. Dirichlet − 4 | s |\n"
         "|---|--:|--:|--:|---|--:|---|---|--:|--:|--:|--:|--:|--:|\n";
}

std::string methodLines(const SurfaceRow& row) {
  std::string lines;
  for (const MeasuredMap& m : row.maps) {
    std::string start = "| | | | | | |";
    if (lines.empty())
      start = formatText("| %s | %d | %d | %d | %d, %s | %d |", row.name.c_str(), row.triangles,
                         row.genus, row.loops, m.cones, row.choice.c_str(), row.q);
    const std::string verdict = m.note.empty() ? m.verdict : m.verdict + ": " + m.note;
    lines += start + formatText(" %s | %s | %d |", m.name.c_str(), verdict.c_str(), m.steps);
    lines += m.verdict == "no map"
                 ? std::string(" | | | |")
                 : formatText(" %.4f | %.4f | %.3f | %.4f |", m.meanMu, m.p95Mu, m.sigma, m.excess);
    lines += formatText(" %.2f |\n", m.seconds);
  }
  if (!row.failure.empty())
    lines = formatText("| %s | %d | | | %s | | %s | | | | | | | |\n", row.name.c_str(),
                       row.triangles, row.choice.c_str(), row.failure.c_str());
  return lines;
}

std::string methodSummary(const std::vector<SurfaceRow>& rows) {
  std::string summary = successTable(rows);
  for (const bool areAutomatic : {true, false}) {
    const std::vector<SurfaceRow> part = rowsWith(areAutomatic, rows);
    if (part.empty()) continue;
    summary += areAutomatic ? "\nAutomatic cones:\n\n" : "\nDrawn cones:\n\n";
    summary += ratioTable(part);
  }
  return summary;
}

}  // namespace hgp::bench
