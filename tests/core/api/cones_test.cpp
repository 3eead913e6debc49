// Cones that a session completes, and cones that move to another reading of a surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

Session sessionOf(const MeshData& mesh, const LoadOptions& options = {}) {
  Session session;
  const Status loaded = session.loadArrays(mesh.positions, mesh.triangles, options);
  EXPECT_TRUE(loaded) << (loaded ? "" : loaded.error().message);
  return session;
}

prescription::Prescription conesAt(const std::vector<int>& vertices, int k = 3) {
  prescription::Prescription out;
  out.hasCones = true;
  for (const int v : vertices) out.cones.push_back({v, k, std::nullopt, -1});
  return out;
}

std::vector<int> verticesOf(const prescription::Prescription& p) {
  std::vector<int> out;
  for (const prescription::PrescribedCone& cone : p.cones) out.push_back(cone.vertex);
  return out;
}

std::vector<std::string> codesOf(const Notes& notes) {
  std::vector<std::string> out;
  for (const Note& note : notes) out.push_back(note.code);
  return out;
}

/// The mesh with its vertices numbered backwards.
MeshData reversed(const MeshData& mesh) {
  MeshData out = mesh;
  std::reverse(out.positions.begin(), out.positions.end());
  const int last = static_cast<int>(mesh.positions.size()) - 1;
  for (auto& triangle : out.triangles)
    for (int& v : triangle) v = last - v;
  return out;
}

TEST(Balance, EveryComponentIsBalancedAndTheResultHasAMap) {
  MeshData two = test::icosphere(4).data;
  const MeshData cube = test::cube(4).data;
  const int shift = static_cast<int>(two.positions.size());
  for (Vec3 p : cube.positions) two.positions.push_back({p[0] + 5, p[1], p[2]});
  for (auto t : cube.triangles) two.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  Session session = sessionOf(two);
  const auto made = session.balance(conesAt({3, 40}));
  ASSERT_TRUE(made) << made.error().message;
  const auto read = readPrescription("x.json", *made, 0);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->cones.size(), 16U);
  const auto checked = session.check(*read);
  ASSERT_TRUE(checked);
  EXPECT_TRUE(checked->isGood) << checked->json;
  ASSERT_TRUE(session.parametrize(*read, {}));
  EXPECT_TRUE(session.isCertified());
}

TEST(Transfer, ByExactPositionToAnotherVersionOfTheMesh) {
  const MeshData old = test::icosphere(4).data;
  MeshData now = reversed(old);
  const int last = static_cast<int>(old.positions.size()) - 1;
  now.positions[static_cast<std::size_t>(last - 7)][0] += 1e-12;
  const auto moved = sessionOf(now).transfer(conesAt({0, 7, 12}), sessionOf(old));
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(verticesOf(moved->cones), (std::vector<int>{last, last - 12}));
  EXPECT_EQ(codesOf(moved->lost), (std::vector<std::string>{"moved-cone-gone"}));
  const Json json = Json::parse(moved->json);
  EXPECT_EQ(json["cones"].size(), 2U);
  EXPECT_EQ(json["cones"][0]["k"], 3);
}

TEST(Transfer, ByNumberWhereTheFileIsTheSameReadInAnotherWay) {
  MeshData mesh = test::cube(3).data;
  // Two copies of a vertex, which exact welding joins: vertex 1 is in one of the triangles a copy at the end.
  auto& triangle = mesh.triangles.front();
  const int copied = triangle[0], copy = static_cast<int>(mesh.positions.size());
  mesh.positions.push_back(mesh.positions[static_cast<std::size_t>(copied)]);
  triangle[0] = copy;
  LoadOptions apart, joined;
  apart.weld = LoadOptions::kWeldNever;
  joined.weld = 0.0;
  const auto moved =
      sessionOf(mesh, joined).transfer(conesAt({copied, copy, copied + 9}), sessionOf(mesh, apart));
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_EQ(moved->cones.cones.size(), 2U);
  ASSERT_EQ(codesOf(moved->lost), (std::vector<std::string>{"moved-cone-joined"}));
}

TEST(Transfer, NotToABoundaryNorToPlacesWithSeveralVertices) {
  const test::Shape whole = test::icosphere(4);
  const MeshData open = test::withoutFaces(whole, {0}).data;
  const int onRim = whole.data.triangles[0][0];
  const auto moved = sessionOf(open).transfer(conesAt({onRim, 100}), sessionOf(whole.data));
  ASSERT_TRUE(moved);
  EXPECT_EQ(codesOf(moved->lost), (std::vector<std::string>{"moved-cone-boundary"}));
  // Two spheres at one place.
  MeshData twice = whole.data;
  const int shift = static_cast<int>(twice.positions.size());
  twice.positions.insert(twice.positions.end(), whole.data.positions.begin(),
                         whole.data.positions.end());
  for (const auto& t : whole.data.triangles)
    twice.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  LoadOptions apart;
  apart.weld = LoadOptions::kWeldNever;
  const auto unclear = sessionOf(twice, apart).transfer(conesAt({3}), sessionOf(whole.data));
  ASSERT_TRUE(unclear);
  EXPECT_EQ(codesOf(unclear->lost), (std::vector<std::string>{"moved-cone-several"}));
}

TEST(Transfer, TurningsGoWithTheirLoopAndRotationsWithUnchangedTriangles) {
  const MeshData old = test::puncturedTorus(12, 9).data;
  prescription::Prescription asked = conesAt({});
  asked.boundaries = {{0, -4, -1}};
  asked.handles = {{0, 1}, {1, 0}};
  const auto same = sessionOf(old).transfer(asked, sessionOf(old));
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->lost.empty());
  ASSERT_EQ(same->cones.handles.size(), 2U);
  EXPECT_EQ(same->cones.handles[0].r, 1);
  const auto moved = sessionOf(reversed(old)).transfer(asked, sessionOf(old));
  ASSERT_TRUE(moved);
  ASSERT_EQ(moved->cones.boundaries.size(), 1U);
  EXPECT_EQ(moved->cones.boundaries[0].l, -4);
  EXPECT_EQ(codesOf(moved->lost),
            (std::vector<std::string>{"moved-handle-gone", "moved-handle-gone"}));
  // A tube has two loops: each keeps its own.
  const MeshData tube = test::cylinder(5, 8).data;
  prescription::Prescription turned = conesAt({});
  turned.boundaries = {{1, 0, -1}};
  Session before = sessionOf(tube), after = sessionOf(reversed(tube));
  const auto loops = after.transfer(turned, before);
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->cones.boundaries.size(), 1U);
  const int there = before.loops()->boundaries[1].front();
  const int last = static_cast<int>(tube.positions.size()) - 1;
  const std::vector<int> ring =
      after.loops()->boundaries[static_cast<std::size_t>(loops->cones.boundaries[0].loop)];
  EXPECT_NE(std::find(ring.begin(), ring.end(), last - there), ring.end());
}

/// `count` vertices around a vertex, no two of them neighbours.
std::vector<int> crowd(const SurfaceFacts& facts, int start, std::size_t count) {
  std::vector<int> open = {start}, chosen;
  std::vector<char> isSeen(facts.valence.size(), 0), isNear(facts.valence.size(), 0);
  isSeen[static_cast<std::size_t>(start)] = 1;
  for (std::size_t i = 0; i < open.size() && chosen.size() < count; ++i) {
    const auto v = static_cast<std::size_t>(open[i]);
    const bool isFree = isNear[v] == 0;
    if (isFree) chosen.push_back(open[i]);
    for (auto n = facts.neighbourStart[v]; n < facts.neighbourStart[v + 1]; ++n) {
      const std::size_t w = facts.neighbours[n];
      if (isFree) isNear[w] = 1;
      if (isSeen[w] == 0) open.push_back(static_cast<int>(w));
      isSeen[w] = 1;
    }
  }
  return chosen;
}

TEST(AutomaticGrid, HasAtLeastEightHundredCellsAndFortyPerCone) {
  Session session = sessionOf(test::cube(12).data);
  SolveOptions options;
  options.choosesCells = true;
  ASSERT_TRUE(session.parametrize(std::nullopt, options));
  EXPECT_TRUE(session.isAligned());
  EXPECT_EQ(Json::parse(session.reportJson())["options"]["grid"]["cells"], 800);
  Session many = sessionOf(test::icosphere(20).data);
  prescription::Prescription cones = conesAt(crowd(*many.facts(), 500, 30));
  for (std::size_t i = 0; i < cones.cones.size(); i += 2) cones.cones[i].k = 5;
  const auto all = readPrescription("x.json", *many.balance(cones), 0);
  ASSERT_TRUE(all);
  ASSERT_TRUE(many.parametrize(*all, options));
  EXPECT_EQ(Json::parse(many.reportJson())["options"]["grid"]["cells"], 40 * all->cones.size());
}

TEST(AutomaticGrid, TakesANumberOfCellsThatWorksWhereTheFirstDoesNot) {
  Session session = sessionOf(test::icosphere(20).data);
  prescription::Prescription cones = conesAt(crowd(*session.facts(), 500, 60));
  for (std::size_t i = 0; i < cones.cones.size(); i += 2) cones.cones[i].k = 5;
  const auto all = readPrescription("x.json", *session.balance(cones), 0);
  ASSERT_TRUE(all);
  SolveOptions options;
  options.grid.mode = GridMode::kQuad;
  options.grid.cells = 30;
  ASSERT_TRUE(session.parametrize(*all, options));
  const Json grid = Json::parse(session.reportJson())["components"][0]["grid"];
  ASSERT_FALSE(grid["aligned"].get<bool>());
  ASSERT_GT(grid["workingCells"].get<double>(), 30);
  options.choosesCells = true;
  ASSERT_TRUE(session.parametrize(*all, options));
  EXPECT_TRUE(session.isAligned());
  const double taken = Json::parse(session.reportJson())["options"]["grid"]["cells"];
  EXPECT_EQ(taken, std::ceil(grid["workingCells"].get<double>()));
  // What was taken is what another run with it gives.
  const std::vector<double> uv = session.uv();
  options.choosesCells = false;
  options.grid.cells = taken;
  ASSERT_TRUE(session.parametrize(*all, options));
  EXPECT_EQ(session.uv(), uv);
}

}  // namespace
}  // namespace hgp::api
