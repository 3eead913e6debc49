// Maps of automatic cones: surfaces of every topology, and every option of a run.
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using test::Shape;

Shape stretched(Shape shape, double x, double y, double z) {
  for (Vec3& p : shape.data.positions) p = {x * p[0], y * p[1], z * p[2]};
  return shapes::settled(shape);
}

/// A sphere with a bump, whose map has large changes of scale.
Shape bumpy(int n) {
  Shape shape = shapes::jittered(shapes::icosphere(n), 0.01);
  for (Vec3& p : shape.data.positions) {
    const double to = p[0] * 0.6 + p[1] * 0.64 + p[2] * 0.48;
    const double height = to > 0.8 ? 1.0 + 12.0 * (to - 0.8) : 1.0;
    for (double& c : p) c *= height;
  }
  return shapes::settled(shape);
}

Shape two() {
  Shape both = shapes::jittered(shapes::icosphere(4), 0.02);
  const Shape other = shapes::jittered(shapes::disk(4), 0.02, 3);
  const int first = static_cast<int>(both.data.positions.size());
  for (const Vec3& p : other.data.positions)
    both.data.positions.push_back({p[0] + 4.0, p[1], 0.1 * p[0] * p[1]});
  for (const auto& t : other.data.triangles)
    both.data.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return both;
}

struct Run {
  const char* name;
  Shape shape;
  std::vector<const char*> options;
};

std::vector<Run> runs() {
  const auto sphere = shapes::jittered(shapes::icosphere(5), 0.03);
  const auto genus2 = shapes::jittered(shapes::pretzel(2, 2), 0.04);
  const auto tube = stretched(shapes::jittered(shapes::cylinder(14, 9), 0.02), 1.0, 1.0, 2.5);
  const auto plate = shapes::jittered(shapes::annulus(14, 4), 0.02);
  return {
      {"sphere",
       sphere,
       {"{}",
        R"({"q": 1})",
        R"({"q": 2})",
        R"({"q": 3})",
        R"({"q": 6})",
        R"({"q": 12})",
        R"({"conesFor": "few"})",
        R"({"conesFor": "low-distortion"})",
        R"({"conesFor": "fewer"})",
        R"({"conesFor": "more"})",
        R"({"count": 20})",
        R"({"count": 1})",
        R"({"alignToCurvature": true})",
        R"({"method": "harmonic"})",
        R"({"method": "soft"})",
        R"({"method": "printed"})",
        R"({"method": "all-frames"})",
        R"({"improve": "isometric"})",
        R"({"improve": "conformal"})",
        R"({"improve": "area"})",
        R"({"improve": 0.4})",
        R"({"scale": "unit"})",
        R"({"scale": "fit"})",
        R"({"quality": true})",
        R"({"maxRounds": 1, "method": "soft"})"}},
      {"cube", shapes::jittered(shapes::cube(5), 0.004), {"{}", R"({"alignToCurvature": true})"}},
      {"bumpy", bumpy(6), {"{}", R"({"conesFor": "few"})", R"({"conesFor": "low-distortion"})"}},
      {"octahedron", shapes::octahedron(), {"{}", R"({"q": 2})"}},
      {"torus",
       shapes::jittered(shapes::torus(16, 9), 0.02),
       {"{}", R"({"conesFor": "low-distortion"})"}},
      {"genus 2",
       genus2,
       {"{}", R"({"q": 2})", R"({"q": 3})", R"({"method": "soft"})", R"({"method": "printed"})"}},
      {"genus 3",
       shapes::jittered(shapes::pretzel(3, 2), 0.05),
       {"{}", R"({"improve": "isometric"})"}},
      {"disk",
       shapes::jittered(shapes::disk(6), 0.02),
       {"{}", R"({"boundary": "convex"})", R"({"conesFor": "low-distortion"})",
        R"({"q": 6, "boundary": "convex"})"}},
      {"annulus", plate, {"{}", R"({"boundary": "convex"})", R"({"method": "all-frames"})"}},
      {"tube", tube, {"{}", R"({"q": 3})", R"({"improve": "isometric", "count": 8})"}},
      {"punctured torus",
       shapes::jittered(shapes::puncturedTorus(14, 9), 0.02),
       {"{}", R"({"q": 6})"}},
      {"three holes",
       shapes::jittered(shapes::withoutFaces(shapes::icosphere(5), {0, 120, 300}), 0.02),
       {"{}", R"({"boundary": "convex"})"}},
      {"two components", two(), {"{}", R"({"count": 12})", R"({"scale": "fit"})"}},
      {"one triangle", shapes::triangle(), {"{}"}},
  };
}

}  // namespace

std::vector<Scenario> maps() {
  std::vector<Scenario> all;
  for (const Run& run : runs())
    for (const char* options : run.options)
      all.push_back({std::string(run.name) + " " + options, [run, options](Recorder& r) {
                       api::Session session = loaded(run.shape.data);
                       solve(r, session, std::nullopt, options);
                     }});
  return all;
}

}  // namespace hgp::recorded
