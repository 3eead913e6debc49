#include "distortion_table.h"

#include "distortion_run.h"
#include "hgp/base/check.h"
#include "ratios.h"

namespace hgp::bench {
namespace {

/// Whether the plain map has enough distortion for a comparison, and no run was cut short.
bool isMeasurable(const SurfaceRow& row, const MeasuredMap& a, const MeasuredMap& b) {
  const MeasuredMap& plain = row.maps.front();
  return plain.isCertified && plain.excess >= kMeasurableExcess && a.note != "time limit" &&
         b.note != "time limit";
}

}  // namespace

std::string distortionHead() {
  return "| surface | F | g | loops | q | map | cones | μ mean | μ 95 % | σ log₂ area | sym. "
         "Dirichlet − 4 | flips | steps | s |\n"
         "|---|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string distortionLines(const SurfaceRow& row) {
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

std::string improvementSummary(const std::vector<SurfaceRow>& rows) {
  const auto ratio = [&](const char* label, const char* of, const char* to,
                         const Ratios::Number& number) {
    return Ratios(rows, of, to, number, isMeasurable).cells(label);
  };
  std::string text = ratioHead();
  text += ratio("excess, isometric to plain", kIsometric, kPlain, excessOf);
  text += ratio("energy, isometric to free SLIM", kIsometric, kFreeSlim, energyOf);
  text += ratio("excess, isometric to free SLIM", kIsometric, kFreeSlim, excessOf);
  text += ratio("excess, isometric to SLIM with seams held", kIsometric, kSeamlessSlim, excessOf);
  text += ratio("σ, isometric to plain", kIsometric, kPlain, sigmaOf);
  text += ratio("mean μ, conformal to plain", kConformal, kPlain, muOf);
  text += ratio("mean μ, LSCM to plain", kLscm, kPlain, muOf);
  text += ratio("mean μ, conformal to LSCM", kConformal, kLscm, muOf);
  text += ratio("seconds that isometric adds, to plain", kIsometric, kPlain, secondsOf);
  text += ratio("seconds that conformal adds, to plain", kConformal, kPlain, secondsOf);
  text += ratio("seconds, SLIM with seams held to isometric", kSeamlessSlim, kIsometric, secondsOf);
  return text;
}

std::string coneSummary(const std::vector<SurfaceRow>& rows) {
  std::string text = ratioHead();
  for (const char* choice : {"balanced", "few", "low-distortion", kFieldCount}) {
    const auto ratio = [&](const char* label, const Ratios::Number& number) {
      const std::string name = std::string(label) + ", " + choice + " to field";
      return Ratios(rows, choice, kFieldCones, number, isMeasurable).cells(name);
    };
    text += ratio("cones", conesOf) + ratio("σ", sigmaOf) + ratio("mean μ", muOf) +
            ratio("excess", excessOf) + ratio("seconds", secondsOf);
  }
  return text;
}

}  // namespace hgp::bench
