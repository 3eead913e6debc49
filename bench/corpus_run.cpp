#include "corpus_run.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "files.h"
#include "hgp/api/option_words.h"
#include "hgp/api/session.h"

namespace hgp::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Json = nlohmann::json;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Peak memory of the process; 0 if the system does not provide it.
double peakMegabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

void addStages(CorpusRow& row, const Json& component) {
  std::map<std::string, double> seconds;
  for (const Json& t : component["times"]) {
    seconds[t["stage"].get<std::string>()] += t["seconds"].get<double>();
  }
  row.cutSeconds += seconds["cut"] + seconds["assemble"];
  row.solveSeconds += seconds["solve"];
  row.fieldSeconds +=
      seconds["prepare"] + seconds["cones"] + seconds["connection"] + seconds["field"];
}

void addMeasures(CorpusRow& row, const Json& component) {
  const int triangles = component["triangles"].get<int>();
  const Json& d = component["distortion"];
  const double weight = double(triangles) / std::max(1, row.triangles);
  row.meanMu += weight * d["meanMu"].get<double>();
  row.rmsLogArea += weight * d["rmsLogArea"].get<double>();
  row.p95Mu = std::max(row.p95Mu, d["p95Mu"].get<double>());
  row.maxMu = std::max(row.maxMu, d["maxMu"].get<double>());
  const Json& reasons = component["reasons"];
  if (!reasons.empty() && row.reason.empty()) row.reason = reasons[0]["message"];
}

/// Reads the numbers from hgp-report, the document that `hgp param --json` prints.
void readReport(CorpusRow& row, const std::string& text) {
  const Json report = Json::parse(text);
  const Json& certificate = report["certificate"];
  row.flipped = certificate["flipped"];
  for (const Json& component : report["components"]) {
    row.cones += component["cones"].get<int>();
    row.rounds += static_cast<int>(component["rounds"].size());
    addStages(row, component);
  }
  for (const Json& component : certificate["components"]) addMeasures(row, component);
}

void solve(CorpusRow& row, api::Session& session, const CorpusOptions& options) {
  const auto start = Clock::now();
  api::SolveOptions solve;
  solve.q = options.q;
  if (!options.improve.empty())
    solve.improve.emplace().balance = api::improveBalance(options.improve).value_or(0.0);
  if (options.timeLimit > 0) {
    solve.progress = [&](const ProgressReport&) { return secondsSince(start) < options.timeLimit; };
  }
  const Status solved = session.parametrize(std::nullopt, solve);
  if (!solved) {
    const bool isLate = solved.error().code == ErrorCode::kCancelled;
    row.reason = isLate ? "time limit" : solved.error().message;
    return;
  }
  readReport(row, session.reportJson());
  if (session.isCertified()) {
    row.outcome = Outcome::kCertified;
    row.reason.clear();
  }
}

void writeMap(CorpusRow& row, const api::Session& session, const CorpusOptions& options) {
  const auto start = Clock::now();
  api::WriteOptions write;
  write.name = options.output;
  const Result<api::WrittenMap> written = session.write(write);
  const Status saved = written ? cli::writeFiles(options.output, written->files) : written.error();
  if (!saved) {
    row.outcome = Outcome::kFailed;
    row.reason = saved.error().message;
  }
  row.writeSeconds = secondsSince(start);
}

void describeSurface(CorpusRow& row, const api::Session& session) {
  row.vertices = static_cast<int>(session.positions().size() / 3);
  row.triangles = static_cast<int>(session.triangles().size() / 3);
  const Result<api::Verdict> verdict = session.inspect();
  if (!verdict) {
    row.outcome = Outcome::kRefused;
    row.reason = verdict.error().message;
    return;
  }
  if (!verdict->isGood) {
    row.outcome = Outcome::kRefused;
    row.reason = verdict->reason ? verdict->reason->message : "not usable";
    return;
  }
  const Json facts = Json::parse(verdict->json);
  for (const Json& component : facts["components"]) {
    ++row.components;
    row.genus += component.value("genus", 0);
    row.loops += static_cast<int>(component["boundaryLoops"].size());
  }
}

}  // namespace

const char* outcomeName(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCertified:
      return "certified";
    case Outcome::kRefused:
      return "refused";
    case Outcome::kFailed:
      break;
  }
  return "FAILED";
}

CorpusRow runMesh(const std::string& file, const std::string& name, const CorpusOptions& options) {
  CorpusRow row;
  row.name = name;
  const auto start = Clock::now();
  api::LoadOptions load;
  load.fix.degenerate = options.fixDegenerate;
  api::Session session;
  Result<io::FileSet> files = cli::openFiles(file, "", "", load.limits.maxBytes);
  Status loaded = files ? session.load(std::move(*files), load) : Status(files.error());
  row.readSeconds = secondsSince(start);
  if (!loaded) {
    row.outcome = Outcome::kRefused;
    row.reason = loaded.error().message;
  } else {
    describeSurface(row, session);
    if (row.outcome != Outcome::kRefused) solve(row, session, options);
    if (row.outcome == Outcome::kCertified && !options.output.empty())
      writeMap(row, session, options);
  }
  row.totalSeconds = secondsSince(start);
  row.peakMegabytes = peakMegabytes();
  return row;
}

std::string reproduction(const std::string& file, const CorpusOptions& options) {
  std::string command = "hgp param " + file + " -o out.obj";
  if (options.q != 4) command += " --q " + std::to_string(options.q);
  if (!options.improve.empty()) command += " --improve " + options.improve;
  if (options.fixDegenerate) command += " --fix degenerate";
  return command;
}

}  // namespace hgp::bench
