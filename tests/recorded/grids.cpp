// Alignment to a grid, quads, lines along features.
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using test::Shape;

void aligned(Recorder& r, const Shape& shape, const char* options,
             const char* prescription = nullptr) {
  api::Session session = loaded(shape.data);
  std::optional<prescription::Prescription> cones;
  if (prescription) cones = readCones(prescription);
  solve(r, session, cones, options);
  r.fact("aligned", session.isAligned() ? "yes" : "no");
  for (const char* name : {"quads.obj", "quads.glb"}) {
    const Result<api::QuadFile> quads = session.quads(name);
    if (!quads) return r.failure("quads", quads.error());
    r.fact("quads", quads->quads);
    r.fact("clipped", quads->clipped);
    r.fact("cuts", quads->cuts);
    r.fact("folded", quads->foldedInSpace);
    r.bytes("file", quads->bytes.data(), quads->bytes.size());
  }
}

void listed(Recorder& r, const Shape& shape, const char* prescription) {
  const api::Session session = loaded(shape.data);
  for (const char* name : {"f.json", "f.sharp", "f.obj", "f.txt"}) {
    const auto list = session.features(readCones(prescription), name);
    if (!list) return r.failure("features", list.error());
    r.text(name, list->text);
    r.fact("creases", list->creaseEdges);
    r.fact("rims", list->rimEdges);
    r.fact("runs", list->chains);
  }
}

}  // namespace

std::vector<Scenario> grids() {
  const Shape sphere = shapes::jittered(shapes::icosphere(6), 0.02);
  const Shape cube = shapes::jittered(shapes::cube(6), 0.002);
  const Shape bar = shapes::pretzel(1, 3);
  const Shape tube = shapes::jittered(shapes::cylinder(16, 9), 0.01);
  const Shape plate = shapes::jittered(shapes::annulus(16, 5), 0.01);
  const Shape genus2 = shapes::jittered(shapes::pretzel(2, 2), 0.02);
  const Shape torus = shapes::jittered(shapes::torus(16, 9), 0.02);
  const char* creases = R"({"format":"hgp-cones","version":1,"q":4,"features":{"creases":40}})";
  const char* rims = R"({"format":"hgp-cones","version":1,"q":4,"features":{"rims":true}})";
  const char* line =
      R"({"format":"hgp-cones","version":1,"q":4,"features":{"creases":40,"lines":[{"vertices":[0,1,2]}]}})";
  struct Run {
    const char* name;
    const Shape& shape;
    const char* options;
    const char* prescription = nullptr;
  };
  std::vector<Scenario> all;
  for (
      const Run& run : std::vector<Run>{
          {"quads of a sphere", sphere, R"({"grid": {"cells": 300, "mode": "quad"}})"},
          {"tiles of a sphere", sphere, R"({"grid": {"cells": 120, "mode": "tile"}})"},
          {"few cells", sphere, R"({"grid": {"cells": 20, "mode": "quad"}})"},
          {"cells of a length", cube, R"({"grid": {"spacing": 0.11, "mode": "quad"}})"},
          {"cells by the program", cube, R"({"grid": {"mode": "quad"}})"},
          {"q 2", sphere, R"({"q": 2, "grid": {"cells": 200, "mode": "tile"}})"},
          {"quads, improved", cube,
           R"({"improve": "isometric", "alignToCurvature": true, "grid": {"cells": 250, "mode": "quad"}})"},
          {"quads of a tube", tube, R"({"grid": {"cells": 150, "mode": "quad"}})"},
          {"quads of a ring", plate, R"({"grid": {"cells": 100, "mode": "quad"}})"},
          {"quads of genus 2", genus2, R"({"grid": {"cells": 400, "mode": "quad"}})"},
          {"quads of a torus", torus, R"({"grid": {"cells": 200, "mode": "quad"}})"},
          {"creases of a cube", cube, "{}", creases},
          {"creases of a cube, quads", cube, R"({"grid": {"cells": 200, "mode": "quad"}})",
           creases},
          {"creases of a bar", bar, "{}", creases},
          {"creases of a bar, quads", bar, R"({"grid": {"cells": 300, "mode": "quad"}})", creases},
          {"rims of a tube", tube, "{}", rims},
          {"rims of a ring, quads", plate, R"({"grid": {"cells": 120, "mode": "quad"}})", rims}})
    all.push_back(
        {run.name, [shape = run.shape, options = run.options, prescription = run.prescription](
                       Recorder& r) { aligned(r, shape, options, prescription); }});
  all.push_back({"features of a cube", [=](Recorder& r) { listed(r, cube, creases); }});
  all.push_back({"features of a ring", [=](Recorder& r) { listed(r, plate, rims); }});
  all.push_back({"features and a line", [=](Recorder& r) { listed(r, bar, line); }});
  return all;
}

}  // namespace hgp::recorded
