// What follows a map: a dragged cone, another run.
#include "hgp/api/file_maps.h"
#include "hgp/api/live_drag.h"
#include "hgp/api/options_from_json.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using test::Shape;

/// Drags the first cone along the vertices `way`, and drops it.
void dragged(Recorder& r, const Shape& shape, const std::vector<int>& way,
             const char* options = "{}") {
  api::Session session = loaded(shape.data);
  solve(r, session, std::nullopt, options);
  const prescription::Prescription cones = readCones(session.conesJson());
  if (cones.cones.empty()) return r.fact("cone", "none");
  Result<api::LiveDrag> drag = api::LiveDrag::begin(session, cones.cones.front().vertex);
  if (!drag) return r.failure("drag", drag.error());
  for (int vertex : way) {
    for (int steps = 0; steps < 30; ++steps) {
      const Result<api::LiveView> view = drag->moveTo(vertex);
      if (!view) {
        r.failure("frame", view.error());
        break;
      }
      r.fact("frame", liveStateName(view->state));
      if (view->state != LiveState::kHeat) break;
      const Result<int> reached = drag->prepareToward(vertex);
      r.fact("reached", reached ? *reached : -1);
      if (!reached) break;
    }
  }
  if (const Status done = drag->drop(); !done) return r.failure("drop", done.error());
  // Frames use functions of the C library: their uv are not the same bits on every machine.
  r.fact("is", session.isCertified() ? "certified" : "not-certified");
  r.numbers("corners", session.cornerToUv());
  r.json("prescription", session.conesJson());
}

/// A result that is used again after another one, and by a session of another mesh.
void keptResults(Recorder& r, const Shape& a, const Shape& b) {
  api::Session session = loaded(a.data);
  solve(r, session, std::nullopt, "{}");
  const api::StoredResult first = session.result();
  solve(r, session, std::nullopt, R"({"q": 6})");
  r.fact("use", session.use(first) ? "yes" : "no");
  recordMap(r, session);
  api::Session other = loaded(b.data);
  r.fact("foreign", other.use(first) ? "yes" : "no");
  api::FileMaps maps{api::WriteOptions{}};
  if (const Status done = maps.add(session); !done) r.failure("add", done.error());
  const Result<api::WrittenFile> written = maps.write();
  if (!written) return r.failure("write", written.error());
  for (const io::OutputFile& file : written->files)
    r.bytes("file", file.bytes.data(), file.bytes.size());
}

}  // namespace

std::vector<Scenario> edits() {
  const Shape sphere = shapes::jittered(shapes::icosphere(7), 0.02);
  const Shape torus = shapes::jittered(shapes::torus(20, 12), 0.02);
  const Shape genus2 = shapes::jittered(shapes::pretzel(2, 2), 0.03);
  const Shape tube = shapes::jittered(shapes::cylinder(16, 9), 0.02);
  const char* count = R"({"count": 8})";
  return {
      {"dragged on a sphere",
       [=](Recorder& r) {
         dragged(r, sphere, {200, 201, 330});
       }},
      {"dragged on a torus",
       [=](Recorder& r) {
         dragged(r, torus, {60, 61, 140, 20}, R"({"conesFor": "low-distortion"})");
       }},
      {"dragged on genus 2",
       [=](Recorder& r) {
         dragged(r, genus2, {40, 150, 80, 260});
       }},
      {"dragged on a tube",
       [=](Recorder& r) {
         dragged(r, tube, {40, 75, 90, 3}, count);
       }},
      {"kept results", [=](Recorder& r) { keptResults(r, shapes::icosphere(3), torus); }},
  };
}

}  // namespace hgp::recorded
