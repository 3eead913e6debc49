#include "stress_run.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "child_process.h"
#include "files.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "hgp/field/prescribed_field.h"
#include "hgp/prescription/cones.h"
#include "processor_time.h"
#include "row_json.h"

namespace hgp::stress {
namespace {

using Json = nlohmann::json;

prescription::Prescription asPrescription(const HolonomySpec& spec) {
  prescription::Prescription out;
  out.q = spec.q;
  out.hasCones = true;
  for (const ConePoint& c : spec.cones) out.cones.push_back({c.vertex.i, c.k, {}});
  for (std::size_t j = 0; j < spec.turning.size(); ++j)
    if (spec.turning[j]) out.boundaries.push_back({static_cast<int>(j), *spec.turning[j], -1});
  for (std::size_t i = 0; i < spec.handles.size(); ++i)
    if (spec.handles[i]) out.handles.push_back({static_cast<int>(i), *spec.handles[i]});
  return out;
}

Row rowOf(const Task& task) {
  Row row;
  row.name = task.name;
  row.mesh = task.mesh;
  row.family = task.family;
  row.triangles = static_cast<int>(task.data.triangles.size());
  row.isAutomatic = !task.spec;
  row.q = task.spec ? task.spec->q : 4;
  if (task.spec) row.cones = static_cast<int>(task.spec->cones.size());
  row.areHandlesGiven = task.spec && !task.spec->handles.empty();
  return row;
}

bool hasNote(const Json& notes, const std::string& code) {
  return std::any_of(notes.begin(), notes.end(),
                     [&](const Json& note) { return note["code"] == code; });
}

void readReport(Row& row, const Json& report, bool isCertified) {
  const Json& component = report["components"].at(0);
  const Json& certificate = report["certificate"];
  const Json& measured = certificate["components"].at(0);
  row.cones = component["cones"];
  row.rounds = static_cast<int>(component["rounds"].size());
  if (row.rounds > 0) row.method = component["rounds"].back()["method"];
  const Json& notes = component["notes"];
  row.isWarned = hasNote(notes, "map-stretched") || hasNote(notes, "map-unresolved");
  row.flipped = certificate["flipped"];
  row.genus = measured["genus"];
  row.loops = measured["boundaryLoops"];
  row.meanMu = measured["distortion"]["meanMu"];
  row.rmsLogArea = measured["distortion"]["rmsLogArea"];
  row.symmetricDirichlet = measured["distortion"]["symmetricDirichlet"];
  if (!measured["reasons"].empty()) row.reason = measured["reasons"][0]["message"];
  const bool areIntegersRight =
      row.flipped == 0 && certificate["wrongAngles"] == 0 && certificate["wrongTurnings"] == 0;
  row.verdict = isCertified && certificate["usable"] ? Verdict::kCertified
                : areIntegersRight                   ? Verdict::kTooFine
                : hasNote(notes, "angle-shortage")   ? Verdict::kTooCoarse
                                                     : Verdict::kFailed;
}

void solve(Row& row, const Task& task, const RunOptions& options) {
  api::Session session;
  if (Status loaded = session.loadArrays(task.data.positions, task.data.triangles, {}); !loaded) {
    row.reason = loaded.error().message;
    return;
  }
  api::SolveOptions solve = options.solve;
  const double start = bench::processorSeconds();
  solve.progress = [&](const ProgressReport&) {
    return bench::processorSeconds() - start < options.timeLimit;
  };
  std::optional<prescription::Prescription> asked;
  if (task.spec) asked = asPrescription(*task.spec);
  const Status solved = session.parametrize(asked, solve);
  row.seconds = bench::processorSeconds() - start;
  if (!solved) {
    row.reason = solved.error().message;
    if (solved.error().code == ErrorCode::kCancelled) row.verdict = Verdict::kLate;
    return;
  }
  readReport(row, Json::parse(session.reportJson()), session.isCertified());
}

/// Predicts the range of scales from the prescription, before anything is solved.
void predict(Row& row, const Task& task) {
  const auto mesh = buildTriMesh(task.data);
  if (!mesh) return;
  const auto context = prepareFields(*mesh);
  if (!context) return;
  row.genus = context->topology.genus;
  row.loops = static_cast<int>(context->topology.loops.size());
  if (!task.spec) return;
  const auto field = prescribedField(*mesh, *context, *task.spec);
  if (field) row.scaleRange = field->scaleRange;
  const auto budget = checkPrescription(*mesh, context->topology, *task.spec);
  if (row.verdict == Verdict::kFailed && budget && budget->isTooCoarse)
    row.verdict = Verdict::kTooCoarse;
}

std::string fileName(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == '/' || c == ' '; }, '_');
  return name;
}

}  // namespace

const char* verdictName(Verdict verdict) {
  static const char* const kNames[] = {
      "certified", "too fine for float64", "too coarse", "FAILED", "LATE", "CRASHED"};
  return kNames[static_cast<int>(verdict)];
}

Row runApart(const Task& task, const RunOptions& options) {
  const auto work = [&] {
    Row row = rowOf(task);
    solve(row, task, options);
    predict(row, task);
    return toJson(row).dump(-1, ' ', false, Json::error_handler_t::replace);
  };
  const Result<std::string> text =
      bench::runInChild(work, {0.0, options.timeLimit > 0 ? 1.5 * options.timeLimit + 10 : 0.0});
  if (text) return rowFromJson(Json::parse(*text));
  Row row = rowOf(task);
  row.reason = text.error().message;
  const bool isLate = row.reason.find("CPU time") != std::string::npos;
  row.verdict = isLate ? Verdict::kLate : Verdict::kCrashed;
  return row;
}

std::string saveReproducer(const Task& task, const RunOptions& options, const std::string& folder) {
  const std::string path = folder + "/" + fileName(task.name);
  const io::Bytes bytes = io::writePlainObj(task.data, {}, task.name);
  Status saved =
      cli::writeText(path + ".obj", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  std::string command = "hgp param " + path + ".obj -o out.obj";
  if (task.spec) {
    if (saved)
      saved = cli::writeText(path + ".cones.json",
                             prescription::writeConesJson(asPrescription(*task.spec)));
    command += " --cones " + path + ".cones.json";
  }
  if (options.solve.improve) command += " --improve isometric";
  if (options.solve.maxRounds != api::SolveOptions().maxRounds)
    command += formatText(" --rounds %d", options.solve.maxRounds);
  return saved ? command : "(not saved: " + saved.error().message + ")";
}

}  // namespace hgp::stress
