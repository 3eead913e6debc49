// Symmetric maps of whole models: several components, planes that no edge lies in, and the choice of the plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

/// The shape with p ↦ move + scale · p.
MeshData placed(const test::Shape& shape, const Vec3& move, const Vec3& scale = {1, 1, 1}) {
  MeshData out = shape.data;
  for (Vec3& p : out.positions)
    for (std::size_t k = 0; k < 3; ++k) p[k] = move[k] + scale[k] * p[k];
  return out;
}

Session sessionOf(const std::vector<MeshData>& parts) {
  MeshData all;
  for (const MeshData& part : parts) {
    const int first = static_cast<int>(all.positions.size());
    all.positions.insert(all.positions.end(), part.positions.begin(), part.positions.end());
    for (const auto& [a, b, c] : part.triangles)
      all.triangles.push_back({first + a, first + b, first + c});
  }
  Session session;
  EXPECT_TRUE(session.loadArrays(all.positions, all.triangles, {}));
  return session;
}

Status solve(Session& session, Symmetry symmetry) {
  SolveOptions options;
  options.symmetry = symmetry;
  return session.parametrize(std::nullopt, options);
}

Json noteOf(const Session& session, const char* code) {
  const Json report = Json::parse(session.reportJson());
  for (const Json& note : report["notes"])
    if (note["code"] == code) return note;
  return {};
}

std::vector<std::string> planesOf(const Session& session) {
  std::vector<std::string> names;
  const Json inspected = Json::parse(session.inspect()->json);
  for (const Json& plane : inspected["mirrors"]) names.push_back(plane["name"]);
  return names;
}

TEST(Symmetric, SeveralComponentsAreMapped) {
  for (const test::Shape& shape : {test::octahedron(), test::icosphere(2)}) {
    std::vector<MeshData> parts;
    for (int n = 0; n < 5; ++n) parts.push_back(placed(shape, {0, 0, 3.0 * n}, {1.5, 1.0, 0.7}));
    Session session = sessionOf(parts);
    ASSERT_TRUE(solve(session, Symmetry::kX)) << shape.name;
    EXPECT_TRUE(session.isCertified()) << shape.name;
    EXPECT_FALSE(noteOf(session, "symmetric").is_null());
  }
}

TEST(Symmetric, APlaneWithoutEdgesGetsThem) {
  // Of this octahedron, only two edges cross X = 0, and two vertices lie in it.
  test::Shape shape = test::octahedron();
  for (Vec3& p : shape.data.positions) p = {p[0] - p[1], p[0] + p[1], p[2]};
  for (const Symmetry plane : {Symmetry::kX, Symmetry::kY}) {
    Session session = sessionOf({shape.data});
    ASSERT_TRUE(solve(session, plane));
    EXPECT_TRUE(session.isCertified());
    EXPECT_FALSE(noteOf(session, "symmetric-split").is_null());
    EXPECT_FALSE(noteOf(session, "symmetric").is_null());
  }
}

TEST(Symmetric, FeaturesWhoseEdgesMustBeSplitHaveAMap) {
  prescription::Prescription rims;
  rims.features.hasRims = true;
  Session session = sessionOf({test::triangle().data});
  ASSERT_TRUE(session.parametrize(rims, {}));
  EXPECT_TRUE(session.isCertified());
  EXPECT_FALSE(noteOf(session, "features-split").is_null());
}

/// Two balls that are images of each other across X and no images of themselves.
struct Pair {
  MeshData first = placed(test::jittered(test::icosphere(2), 0.1), {2, 0, 0}, {0.6, 1, 0.7});
  MeshData second = first;

  Pair() {
    for (Vec3& p : second.positions) p[0] = -p[0];
    std::reverse(second.positions.begin(), second.positions.end());
    const int last = static_cast<int>(second.positions.size()) - 1;
    for (auto& [a, b, c] : second.triangles) {
      a = last - a;
      b = last - std::exchange(c, last - b);
    }
    std::rotate(second.triangles.begin(), second.triangles.begin() + 7, second.triangles.end());
  }
  int image(int v) const { return 2 * static_cast<int>(second.positions.size()) - 1 - v; }
};

Status solveWith(Session& session, const std::vector<std::pair<int, int>>& cones) {
  prescription::Prescription asked;
  asked.q = 4;
  asked.hasCones = true;
  for (const auto& [v, k] : cones) asked.cones.push_back({v, k, {}});
  SolveOptions options;
  options.symmetry = Symmetry::kX;
  return session.parametrize(asked, options);
}

TEST(Symmetric, ComponentsThatAreImagesOfEachOtherHaveImagesOfOneMap) {
  const Pair pair;
  Session session = sessionOf({pair.first, pair.second});
  EXPECT_EQ(planesOf(session), std::vector<std::string>{"X"});
  ASSERT_TRUE(solve(session, Symmetry::kAuto));
  EXPECT_TRUE(session.isCertified());
  EXPECT_EQ(noteOf(session, "symmetric")["numbers"]["pairs"], 1);
}

TEST(Symmetric, ConesOfOneOfAPairAreThoseOfBoth) {
  const Pair pair;
  std::vector<std::pair<int, int>> first, second, both, others;
  for (const int v : {0, 3, 11, 17, 20, 26, 32, 40}) {
    first.emplace_back(v, 3);
    second.emplace_back(pair.image(v), 3);
  }
  for (const auto* list : {&first, &second}) both.insert(both.end(), list->begin(), list->end());
  for (const auto* cones : {&first, &second, &both}) {
    Session session = sessionOf({pair.first, pair.second});
    ASSERT_TRUE(solveWith(session, *cones));
    EXPECT_TRUE(session.isCertified());
    const Json report = Json::parse(session.reportJson());
    std::vector<std::pair<int, int>> found;
    for (const Json& cone : report["cones"]["cones"])
      found.emplace_back(cone["vertex"].get<int>(), cone["k"].get<int>());
    std::sort(found.begin(), found.end());
    std::sort(both.begin(), both.end());
    EXPECT_EQ(found, both);
  }
  others = both;
  for (auto& cone : others)
    if (cone.first == 3) cone.first = 4;
  Session session = sessionOf({pair.first, pair.second});
  const Status done = solveWith(session, others);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUsage);
  std::vector<std::int64_t> places;
  for (const Where& w : done.error().where) places.push_back(w.id);
  EXPECT_EQ(places, (std::vector<std::int64_t>{pair.image(4), pair.image(3)}));
}

TEST(Symmetric, AComponentWithoutAnImageIsNamed) {
  const Pair pair;
  Session session = sessionOf(
      {pair.first, pair.second, placed(test::jittered(test::icosphere(2), 0.1), {0, 5, 0})});
  const Status done = solve(session, Symmetry::kX);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(done.error().message.find("component 2"), std::string::npos);
}

TEST(Symmetric, ATinyComponentMustBeSymmetricItself) {
  const test::Shape ball = test::icosphere(3);
  const Vec3 small{1e-4, 1e-4, 1e-4};
  Session good = sessionOf({ball.data, placed(ball, {0, 0, 0}, small)});
  EXPECT_EQ(planesOf(good), (std::vector<std::string>{"X", "Y", "Z"}));
  Session bad = sessionOf({ball.data, placed(test::jittered(ball, 0.1), {0, 0, 0}, small)});
  EXPECT_TRUE(planesOf(bad).empty());
  const Status done = solve(bad, Symmetry::kAuto);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kUnsupported);
}

TEST(Symmetric, IsCancelledWhilePlanesAreSearched) {
  Session session = sessionOf({test::jittered(test::icosphere(3), 0.1).data});
  const Status searched = solve(session, Symmetry::kAuto);
  ASSERT_FALSE(searched);
  EXPECT_EQ(searched.error().code, ErrorCode::kUnsupported);
  SolveOptions options;
  options.symmetry = Symmetry::kAuto;
  options.progress = [](const ProgressReport&) { return false; };
  const Status done = session.parametrize(std::nullopt, options);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().code, ErrorCode::kCancelled);
}

TEST(Symmetric, OptionsForConesOfOtherFieldsAreRefused) {
  std::array<SolveOptions, 3> all;
  all[0].coneCount = 12;
  all[1].conesFor = ConesFor::kFew;
  all[2].alignToCurvature = true;
  for (SolveOptions& options : all) {
    options.symmetry = Symmetry::kX;
    Session session = sessionOf({test::icosphere(3).data});
    const Status done = session.parametrize(std::nullopt, options);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().code, ErrorCode::kUsage);
  }
}

}  // namespace
}  // namespace hgp::api
