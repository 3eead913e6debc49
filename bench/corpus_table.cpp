#include "corpus_table.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "row_columns.h"

namespace hgp::bench {
namespace {

using Json = nlohmann::json;

/// Text as a table cell: without line breaks and '|'.
std::string asCell(std::string text) {
  std::replace(text.begin(), text.end(), '|', '/');
  std::replace(text.begin(), text.end(), '\n', ' ');
  constexpr std::size_t kLongest = 140;
  if (text.size() > kLongest) text = text.substr(0, kLongest) + " …";
  return text;
}

constexpr auto eachCorpusColumn = [](auto& r, const auto& visit) {
  visit("name", r.name);
  visit("vertices", r.vertices);
  visit("triangles", r.triangles);
  visit("components", r.components);
  visit("genus", r.genus);
  visit("boundaryLoops", r.loops);
  visit("cones", r.cones);
  visit("rounds", r.rounds);
  visit("flipped", r.flipped);
  visit("reason", r.reason);
  visit("meanMu", r.meanMu);
  visit("p95Mu", r.p95Mu);
  visit("maxMu", r.maxMu);
  visit("rmsLogArea", r.rmsLogArea);
  visit("readSeconds", r.readSeconds);
  visit("fieldSeconds", r.fieldSeconds);
  visit("cutSeconds", r.cutSeconds);
  visit("solveSeconds", r.solveSeconds);
  visit("writeSeconds", r.writeSeconds);
  visit("totalSeconds", r.totalSeconds);
  visit("peakMegabytes", r.peakMegabytes);
};

Json rowToJson(const CorpusRow& row) {
  Json out = columnsOf(row, eachCorpusColumn);
  out["verdict"] = outcomeName(row.outcome);
  return out;
}

}  // namespace

std::string tableHead() {
  return "| mesh | V | F | g | loops | cones | rounds | verdict | μ mean | μ p95 | μ max | area | "
         "read s | field s | cut s | solve s | total s | MB |\n"
         "|---|--:|--:|--:|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n";
}

std::string tableRow(const CorpusRow& r) {
  std::string line = formatText("| %s | %d | %d | ", r.name.c_str(), r.vertices, r.triangles);
  if (r.outcome == Outcome::kRefused) {
    return line + "| | | | refused: " + asCell(r.reason) + " | | | | | " +
           formatText("%.2f | | | | %.2f | %.0f |\n", r.readSeconds, r.totalSeconds,
                      r.peakMegabytes);
  }
  line += formatText("%d | %d | %d | %d | %s", r.genus, r.loops, r.cones, r.rounds,
                     outcomeName(r.outcome));
  if (r.outcome == Outcome::kFailed) line += ": " + asCell(r.reason);
  return line +
         formatText(" | %.4f | %.4f | %.4f | %.2f | %.2f | %.2f | %.2f | %.2f | %.2f | %.0f |\n",
                    r.meanMu, r.p95Mu, r.maxMu, r.rmsLogArea, r.readSeconds, r.fieldSeconds,
                    r.cutSeconds, r.solveSeconds, r.totalSeconds, r.peakMegabytes);
}

std::string totals(const std::vector<CorpusRow>& rows) {
  int certified = 0, refused = 0, failed = 0, firstRound = 0;
  long long triangles = 0;
  double seconds = 0, peak = 0;
  for (const CorpusRow& row : rows) {
    certified += row.outcome == Outcome::kCertified;
    refused += row.outcome == Outcome::kRefused;
    failed += row.outcome == Outcome::kFailed;
    firstRound += row.outcome == Outcome::kCertified && row.rounds <= row.components;
    if (row.outcome == Outcome::kCertified) triangles += row.triangles;
    seconds += row.totalSeconds;
    peak = std::max(peak, row.peakMegabytes);
  }
  return formatText(
      "%zu files: %d certified (%d of them in one round), %d refused, %d FAILED; "
      "%lld triangles mapped; %.1f s; largest peak %.0f MB\n",
      rows.size(), certified, firstRound, refused, failed, triangles, seconds, peak);
}

std::string toJson(const std::vector<CorpusRow>& rows, const CorpusOptions& options) {
  Json out{{"format", "hgp-corpus"}, {"version", 1}};
  out["q"] = options.q;
  out["improve"] = options.improve;
  Json& list = out["meshes"] = Json::array();
  for (const CorpusRow& r : rows) list.push_back(rowToJson(r));
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string toJson(const CorpusRow& row) {
  return rowToJson(row).dump(-1, ' ', false, Json::error_handler_t::replace);
}

CorpusRow rowFromJson(const std::string& text) {
  const Json in = Json::parse(text);
  CorpusRow row;
  readColumns(in, row, eachCorpusColumn);
  for (const Outcome o : {Outcome::kCertified, Outcome::kRefused, Outcome::kFailed}) {
    if (in.at("verdict") == outcomeName(o)) row.outcome = o;
  }
  return row;
}

}  // namespace hgp::bench
