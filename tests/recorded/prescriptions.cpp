// Cones, turnings and handles that are prescribed: those with a map, those without, and what is said of them.
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/base/check.h"
#include "recorded/recorder.h"

namespace hgp::recorded {
namespace {

using Json = nlohmann::json;
using test::Shape;

std::string cones(int q, const std::vector<std::pair<int, int>>& list,
                  const std::vector<int>& turnings = {}, const std::vector<int>& handles = {}) {
  Json json{{"format", "hgp-cones"}, {"version", 1}, {"q", q}, {"cones", Json::array()}};
  for (const auto& [vertex, k] : list) json["cones"].push_back({{"vertex", vertex}, {"k", k}});
  for (std::size_t i = 0; i < turnings.size(); ++i)
    json["boundaries"].push_back({{"loop", i}, {"l", turnings[i]}});
  for (std::size_t i = 0; i < handles.size(); ++i)
    json["handles"].push_back({{"generator", i}, {"r", handles[i]}});
  return json.dump();
}

void asked(Recorder& r, const Shape& shape, const std::string& prescription,
           const char* options = "{}") {
  api::Session session = loaded(shape.data);
  const prescription::Prescription read = readCones(prescription);
  if (const auto verdict = session.check(read); verdict)
    r.json(verdict->isGood ? "valid" : "invalid", verdict->json);
  else
    r.failure("check", verdict.error());
  if (const auto scale = session.logScale(read); scale) r.numbers("scale", *scale);
  solve(r, session, read, options);
}

void facts(Recorder& r, const Shape& shape) {
  const api::Session session = loaded(shape.data);
  const auto facts = session.facts();
  const auto loops = session.loops();
  const auto inspected = session.inspect();
  if (!facts || !loops || !inspected) return r.fact("facts", "none");
  r.numbers("angle", facts->angle);
  r.numbers("valence", facts->valence);
  r.numbers("rims", facts->isBoundary);
  r.numbers("neighbours", facts->neighbours);
  r.numbers("components", facts->triangleComponent);
  for (const std::vector<int>& loop : loops->boundaries) r.numbers("loop", loop);
  for (const auto& walk : loops->handles) r.numbers("handle", walk);
  r.json("inspect", inspected->json);
}

void balanced(Recorder& r, const Shape& shape, const std::string& prescription) {
  api::Session session = loaded(shape.data);
  const auto more = session.balance(readCones(prescription));
  if (!more) return r.failure("balance", more.error());
  r.json("cones", *more);
  solve(r, session, readCones(*more), "{}");
}

Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// The cross field of a direction in space, projected onto the triangles: as .rawfield, or as .ffield with a matching.
std::string crossField(const Shape& shape, bool isFField) {
  const Vec3 axis{0.9, 0.35, 0.2};
  std::string out = formatText(
      isFField ? "target_frame\n%d\nk1 k2 k1v_x k1v_y k1v_z k2v_x k2v_y k2v_z\n" : "4 %d\n",
      static_cast<int>(shape.data.triangles.size()));
  for (const auto& t : shape.data.triangles) {
    std::array<Vec3, 3> p{};
    for (std::size_t k = 0; k < 3; ++k) p[k] = shape.data.positions[static_cast<std::size_t>(t[k])];
    Vec3 a{}, b{};
    for (std::size_t k = 0; k < 3; ++k) a[k] = p[1][k] - p[0][k], b[k] = p[2][k] - p[0][k];
    const Vec3 n = cross(a, b);
    const Vec3 side = cross(n, axis), d = cross(side, n);
    if (isFField) {
      out += formatText("1 1 %.17g %.17g %.17g %.17g %.17g %.17g\n", d[0], d[1], d[2], side[0],
                        side[1], side[2]);
      continue;
    }
    const double long1 = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    const double long2 = std::sqrt(side[0] * side[0] + side[1] * side[1] + side[2] * side[2]);
    for (double sign : {1.0, -1.0}) {
      out += formatText("%.17g %.17g %.17g ", sign * d[0] / long1, sign * d[1] / long1,
                        sign * d[2] / long1);
      out += formatText("%.17g %.17g %.17g ", sign * side[0] / long2, sign * side[1] / long2,
                        sign * side[2] / long2);
    }
    out += "\n";
  }
  return out;
}

void ofField(Recorder& r, const Shape& shape, bool isFField, const char* options) {
  api::Session session = loaded(shape.data);
  const auto field =
      api::readPrescription(isFField ? "a.ffield" : "a.rawfield", crossField(shape, isFField), 4);
  if (!field) return r.failure("field", field.error());
  if (const auto cones = session.convert(*field); cones)
    r.json("converted", *cones);
  else
    r.failure("convert", cones.error());
  solve(r, session, *field, options);
}

void moved(Recorder& r, const Shape& from, const Shape& to) {
  const api::Session before = loaded(from.data);
  api::Session after = loaded(to.data);
  const auto suggested = before.suggest({});
  const auto moved = after.transfer(readCones(suggested->json), before);
  if (!moved) return r.failure("transfer", moved.error());
  r.json("cones", moved->json);
  r.notes("lost", moved->lost);
}

}  // namespace

std::vector<Scenario> prescriptions() {
  const Shape sphere = shapes::jittered(shapes::icosphere(5), 0.03);
  const Shape torus = shapes::jittered(shapes::torus(18, 10), 0.02);
  const Shape genus2 = shapes::jittered(shapes::pretzel(2, 2), 0.04);
  const Shape disk = shapes::jittered(shapes::disk(6), 0.02);
  const Shape tube = shapes::jittered(shapes::cylinder(14, 8), 0.02);
  const Shape holes =
      shapes::jittered(shapes::withoutFaces(shapes::icosphere(5), {0, 120, 300}), 0.02);
  const std::string eight =
      cones(4, {{0, 3}, {1, 3}, {2, 3}, {3, 3}, {4, 3}, {5, 3}, {6, 3}, {7, 3}});
  const std::string steep = cones(4, {{0, 1}, {40, 1}, {90, 2}});
  const std::string pair = cones(4, {{20, 3}, {100, 5}});
  return {
      {"eight corners", [=](Recorder& r) { asked(r, sphere, eight); }},
      {"eight corners, soft",
       [=](Recorder& r) { asked(r, sphere, eight, R"({"method": "soft"})"); }},
      {"eight corners, printed",
       [=](Recorder& r) { asked(r, sphere, eight, R"({"method": "printed"})"); }},
      {"steep", [=](Recorder& r) { asked(r, sphere, steep); }},
      {"steep, printed", [=](Recorder& r) { asked(r, sphere, steep, R"({"method": "printed"})"); }},
      {"steep, all frames",
       [=](Recorder& r) { asked(r, sphere, steep, R"({"method": "all-frames"})"); }},
      {"steep, refined",
       [=](Recorder& r) {
         asked(r, shapes::jittered(shapes::icosphere(2), 0.03),
               cones(4, {{0, 1}, {20, 1}, {30, 2}}), R"({"refine": true})");
       }},
      {"q 12",
       [=](Recorder& r) {
         asked(r, sphere, cones(12, {{0, 7}, {11, 8}, {30, 9}, {60, 20}, {99, 4}}));
       }},
      {"q 3",
       [=](Recorder& r) {
         asked(r, sphere, cones(3, {{0, 2}, {11, 2}, {30, 2}, {60, 2}, {99, 2}, {120, 2}}));
       }},
      {"one large cone",
       [=](Recorder& r) {
         asked(r, torus, cones(4, {{20, 5}, {100, 3}, {60, 3}, {140, 5}}));
       }},
      {"torus, one pair", [=](Recorder& r) { asked(r, torus, pair); }},
      {"torus with handles",
       [=](Recorder& r) {
         asked(r, torus, cones(4, {{20, 5}, {100, 3}, {60, 3}, {140, 5}}, {}, {1, 2}));
       }},
      {"torus without cones", [=](Recorder& r) { asked(r, torus, cones(4, {})); }},
      {"torus, no map with these handles",
       [=](Recorder& r) {
         asked(r, torus, cones(4, {}, {}, {1, 0}));
       }},
      {"genus 2",
       [=](Recorder& r) {
         asked(r, genus2, cones(4, {{30, 8}, {130, 8}, {10, 4}}));
       }},
      {"genus 2 with handles",
       [=](Recorder& r) {
         asked(r, genus2, cones(4, {{30, 6}, {130, 6}, {80, 6}, {160, 6}}, {}, {1, 3, 2, 0}));
       }},
      {"disk with a cone",
       [=](Recorder& r) {
         asked(r, disk, cones(4, {{0, 3}}, {3}));
       }},
      {"disk with a wrong turning",
       [=](Recorder& r) {
         asked(r, disk, cones(4, {{0, 3}}, {5}));
       }},
      {"tube with turnings",
       [=](Recorder& r) {
         asked(r, tube, cones(4, {}, {1, -1}));
       }},
      {"tube with cones",
       [=](Recorder& r) {
         asked(r, tube, cones(6, {{40, 5}, {60, 7}}, {0, 0}));
       }},
      {"three holes, turnings",
       [=](Recorder& r) {
         asked(r, holes, cones(4, {{60, 3}, {90, 5}}, {2, 1}));
       }},
      {"against Gauss and Bonnet",
       [=](Recorder& r) {
         asked(r, sphere, cones(4, {{0, 3}}));
       }},
      {"too few triangles",
       [=](Recorder& r) {
         asked(r, shapes::octahedron(),
               cones(4, {{0, 20}, {1, 1}, {2, 1}, {3, 1}, {4, 1}, {5, 1}}));
       }},
      {"no such vertex",
       [=](Recorder& r) {
         asked(r, sphere, cones(4, {{100000, 3}}));
       }},
      {"on the rim",
       [=](Recorder& r) {
         asked(r, disk, cones(4, {{100, 3}}));
       }},
      {"no map, kept going",
       [=](Recorder& r) {
         asked(r, shapes::icosphere(1), cones(4, {{0, 1}, {1, 1}, {2, 1}, {3, 5}}),
               R"({"keepGoing": true})");
       }},
      {"balance",
       [=](Recorder& r) {
         balanced(r, sphere, cones(4, {{0, 3}, {50, 2}}));
       }},
      {"balance on a torus",
       [=](Recorder& r) {
         balanced(r, torus, cones(4, {{20, 3}, {50, 3}}));
       }},
      {"balance with q 6",
       [=](Recorder& r) {
         balanced(r, holes, cones(6, {{60, 4}}));
       }},
      {"transfer to the same", [=](Recorder& r) { moved(r, sphere, sphere); }},
      {"transfer to another order",
       [=](Recorder& r) { moved(r, sphere, shapes::scattered(sphere)); }},
      {"transfer to a part", [=](Recorder& r) { moved(r, shapes::icosphere(5), holes); }},
      {"a field", [=](Recorder& r) { ofField(r, sphere, false, "{}"); }},
      {"a field and its directions",
       [=](Recorder& r) { ofField(r, sphere, false, R"({"frames": "file"})"); }},
      {"a field on a torus",
       [=](Recorder& r) { ofField(r, torus, false, R"({"frames": "file"})"); }},
      {"a field on a tube", [=](Recorder& r) { ofField(r, tube, true, R"({"frames": "file"})"); }},
      {"facts of a sphere", [=](Recorder& r) { facts(r, sphere); }},
      {"facts of genus 2", [=](Recorder& r) { facts(r, genus2); }},
      {"facts of three holes", [=](Recorder& r) { facts(r, holes); }},
      {"facts of a punctured torus", [=](Recorder& r) { facts(r, shapes::puncturedTorus(9, 7)); }},
  };
}

}  // namespace hgp::recorded
