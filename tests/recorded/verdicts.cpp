// What verify says: of maps as they were written, and of maps with one thing changed.
#include <sstream>

#include "hgp/api/options_from_json.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using test::Shape;
using Lines = std::vector<std::string>;

Lines linesOf(const std::string& text) {
  Lines lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// Where the lines with a keyword are.
std::vector<std::size_t> places(const Lines& lines, const std::string& keyword) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].rfind(keyword + " ", 0) == 0) all.push_back(i);
  return all;
}

void judged(Recorder& r, const Lines& lines, const std::string& cones, const char* options) {
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const api::Session session = loadedFile("map.obj", text);
  const auto read = api::optionsFromJson<api::VerifyOptions>(options);
  for (const bool isPrescribed : {true, false}) {
    std::optional<prescription::Prescription> asked;
    if (isPrescribed) asked = readCones(cones);
    const Result<api::Verdict> verdict = session.verify(asked, *read);
    if (!verdict) {
      r.failure("fails", verdict.error());
      continue;
    }
    r.json(verdict->isGood ? "good" : "bad", verdict->json);
    r.fact("because", verdict->reason ? errorName(verdict->reason->code) : "nothing");
  }
}

/// The map as an OBJ, then with changes of one line or two.
void tampered(Recorder& r, const Shape& shape, const char* options, const char* verify = "{}") {
  api::Session session = loaded(shape.data);
  solve(r, session, std::nullopt, options);
  const Result<api::WrittenMap> written = session.write({});
  if (!written) return r.failure("write", written.error());
  const Lines good =
      linesOf(std::string(written->files[0].bytes.begin(), written->files[0].bytes.end()));
  const std::string cones = session.conesJson();
  const std::vector<std::size_t> uv = places(good, "vt"), faces = places(good, "f");
  judged(r, good, cones, verify);
  Lines swapped = good;
  std::swap(swapped[uv[0]], swapped[uv[uv.size() / 2]]);
  judged(r, swapped, cones, verify);
  Lines torn = good;
  const std::size_t onSeam =
      uv[static_cast<std::size_t>(session.seams().empty() ? 0 : session.seams()[0].a[0])];
  std::istringstream in(good[onSeam].substr(3));
  double u = 0.0, v = 0.0;
  in >> u >> v;
  torn[onSeam] = "vt " + std::to_string(u + 0.001) + " " + std::to_string(v);
  judged(r, torn, cones, verify);
  Lines without = good;
  without.erase(without.begin() + static_cast<std::ptrdiff_t>(faces[faces.size() / 3]));
  judged(r, without, cones, verify);
  Lines mirrored = good;
  for (std::size_t i : uv) {
    std::istringstream row(good[i].substr(3));
    row >> u >> v;
    mirrored[i] = "vt " + std::to_string(-u) + " " + std::to_string(v);
  }
  judged(r, mirrored, cones, verify);
}

}  // namespace

std::vector<Scenario> verdicts() {
  const Shape sphere = shapes::jittered(shapes::icosphere(3), 0.03);
  const Shape torus = shapes::jittered(shapes::torus(12, 7), 0.02);
  const Shape tube = shapes::jittered(shapes::cylinder(10, 5), 0.02);
  const Shape genus2 = shapes::jittered(shapes::pretzel(2), 0.03);
  return {
      {"verdicts on a sphere", [=](Recorder& r) { tampered(r, sphere, "{}"); }},
      {"verdicts on a sphere, q 6",
       [=](Recorder& r) { tampered(r, sphere, R"({"q": 6})", R"({"q": 6})"); }},
      {"verdicts on a torus", [=](Recorder& r) { tampered(r, torus, "{}"); }},
      {"verdicts on a tube",
       [=](Recorder& r) { tampered(r, tube, "{}", R"({"tolerance": 0.01})"); }},
      {"verdicts on genus 2", [=](Recorder& r) { tampered(r, genus2, "{}"); }},
      {"verdicts on a grid",
       [=](Recorder& r) { tampered(r, sphere, R"({"grid": {"cells": 60, "mode": "quad"}})"); }},
  };
}

}  // namespace hgp::recorded
