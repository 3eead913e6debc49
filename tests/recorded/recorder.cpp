#include "recorded/recorder.h"

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "hgp/api/options_from_json.h"
#include "hgp/base/check.h"

namespace hgp::recorded {
namespace {

using Json = nlohmann::json;

std::string hashOf(const void* data, std::size_t size) {
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a
  for (std::size_t i = 0; i < size; ++i) {
    hash ^= static_cast<const unsigned char*>(data)[i];
    hash *= 0x100000001b3;
  }
  return formatText("%010llx", static_cast<unsigned long long>(hash >> 24));
}

/// What depends on the machine is left out, and numbers are rounded.
Json settled(const Json& json) {
  if (json.is_number_float()) {
    const double x = json.get<double>();
    return formatText("%.6g", std::abs(x) < 1e-9 ? 0.0 : x);
  }
  if (json.is_array()) {
    Json out = Json::array();
    for (const Json& one : json) out.push_back(settled(one));
    return out;
  }
  if (!json.is_object()) return json;
  Json out = Json::object();
  for (const auto& [key, value] : json.items())
    if (key != "seconds" && key != "times" && key != "program") out[key] = settled(value);
  return out;
}

}  // namespace

void Recorder::fact(std::string_view key, const std::string& value) {
  line_ += " " + std::string(key) + "=" + value;
}

void Recorder::bytes(std::string_view key, const void* data, std::size_t size) {
  fact(key, std::to_string(size) + ":" + hashOf(data, size));
}

void Recorder::json(std::string_view key, const std::string& text) {
  const std::string all = settled(Json::parse(text)).dump();
  fact(key, hashOf(all.data(), all.size()));
}

void Recorder::failure(std::string_view key, const Failure& failure) {
  fact(key, errorName(failure.code));
  json("error", api::errorJson(failure));
}

void Recorder::notes(std::string_view key, const Notes& notes) {
  std::string all;
  for (const Note& note : notes) all += (all.empty() ? "" : ",") + note.code;
  fact(key, all);
}

prescription::Prescription readCones(const std::string& json) {
  Result<prescription::Prescription> cones = api::readPrescription("cones.json", json, 0);
  HGP_CHECK(cones.hasValue(), "%s", cones ? "" : cones.error().message.c_str());
  return std::move(*cones);
}

api::Session loaded(const MeshData& mesh) {
  api::Session session;
  const Status done = session.loadArrays(mesh.positions, mesh.triangles, {});
  HGP_CHECK(done.hasValue(), "%s", done ? "" : done.error().message.c_str());
  return session;
}

api::Session loadedFile(const std::string& name, const std::string& text,
                        const api::LoadOptions& options) {
  api::Session session;
  io::FileSet files;
  files.name = name;
  files.main.assign(text.begin(), text.end());
  const Status done = session.load(std::move(files), options);
  HGP_CHECK(done.hasValue(), "%s", done ? "" : done.error().message.c_str());
  return session;
}

void recordMap(Recorder& r, const api::Session& session) {
  const Json report = Json::parse(session.reportJson());
  std::string rounds;
  std::size_t cones = 0;
  for (const Json& component : report["components"]) {
    rounds += (rounds.empty() ? "" : "+") + std::to_string(component["rounds"].size());
    cones += component["cones"].get<std::size_t>();
  }
  r.fact("is", session.isCertified() ? "certified" : "not-certified");
  r.fact("cones", static_cast<long long>(cones));
  r.fact("rounds", rounds);
  r.numbers("uv", session.uv());
  r.numbers("corners", session.cornerToUv());
  r.numbers("xref", session.uvToVertex());
  std::vector<std::uint32_t> seams;
  for (const api::SeamEdge& seam : session.seams()) {
    for (const int end : {seam.a[0], seam.a[1], seam.b[0], seam.b[1], seam.r})
      seams.push_back(static_cast<std::uint32_t>(end));
  }
  r.numbers("seams", seams);
  r.json("report", session.reportJson());
  r.json("prescription", session.conesJson());
  const Result<api::MapMeasures> measures = session.measure();
  if (!measures) return r.failure("measures", measures.error());
  r.numbers("stretch", measures->stretch);
  r.numbers("area", measures->logArea);
  r.numbers("chains", measures->seamChain);
  r.fact("overlaps", measures->overlapPairs);
}

void solve(Recorder& r, api::Session& session,
           const std::optional<prescription::Prescription>& cones, std::string_view options) {
  const Result<api::SolveOptions> read = api::optionsFromJson<api::SolveOptions>(options);
  HGP_CHECK(read.hasValue(), "%s", read ? "" : read.error().message.c_str());
  if (const Status done = session.parametrize(cones, *read); !done)
    return r.failure("fails", done.error());
  recordMap(r, session);
}

}  // namespace hgp::recorded
