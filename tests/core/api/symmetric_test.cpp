// Symmetric maps of whole models: several components, planes that no edge lies in, and the choice of the plane.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

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

TEST(Symmetric, APlaneThatExchangesComponentsIsNotTaken) {
  const test::Shape shape = test::icosphere(2);
  Session session = sessionOf(
      {placed(shape, {2, 0, 0}, {0.6, 1, 0.7}), placed(shape, {-2, 0, 0}, {0.6, 1, 0.7})});
  const Status across = solve(session, Symmetry::kX);
  ASSERT_FALSE(across);
  EXPECT_EQ(across.error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(planesOf(session), (std::vector<std::string>{"Y", "Z"}));
  ASSERT_TRUE(solve(session, Symmetry::kAuto));
  EXPECT_TRUE(session.isCertified());
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
