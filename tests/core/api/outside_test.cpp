#include "hgp/api/stored/outside.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

LoadOptions repairing() {
  LoadOptions options;
  options.fix = {true, true, true};
  return options;
}

Session loaded(const std::string& name, io::Bytes bytes) {
  Session session;
  io::FileSet files;
  files.name = name;
  files.main = std::move(bytes);
  const Status done = session.load(std::move(files), repairing());
  EXPECT_TRUE(done.hasValue()) << (done ? "" : done.error().message);
  return session;
}

/// Parametrizes an OBJ of this mesh with repairs, writes it and verifies what was written: everything that
/// says whether it is certified must say the same.
Json certified(const MeshData& mesh, const std::string& name) {
  Session session = loaded("mesh.obj", io::writePlainObj(mesh, {}, ""));
  const Status solved = session.parametrize(std::nullopt, {});
  EXPECT_TRUE(solved) << name << (solved ? "" : solved.error().message);
  if (!solved) return {};
  const Json report = Json::parse(session.reportJson());
  const Json certificate = Json::parse(session.certificateJson());
  EXPECT_TRUE(session.isCertified()) << name << session.certificateJson();
  EXPECT_EQ(report["certified"], session.isCertified()) << name;
  EXPECT_EQ(certificate["certified"], session.isCertified()) << name;
  EXPECT_EQ(report["certificate"], certificate);
  WriteOptions options;
  options.name = "out.obj";
  const Result<WrittenMap> written = session.write(options);
  EXPECT_TRUE(written) << name;
  if (!written) return {};
  const Session again = loaded("out.obj", written->files[0].bytes);
  const Result<Verdict> verdict = again.verify(std::nullopt, {});
  EXPECT_TRUE(verdict && verdict->isGood) << name;
  if (!verdict) return {};
  Json back = Json::parse(verdict->json);
  EXPECT_EQ(back["stored"], certificate["stored"]) << name;
  EXPECT_EQ(back["flipped"], certificate["flipped"]);
  EXPECT_EQ(back["components"].size(), certificate["components"].size());
  return back["stored"];
}

TEST(Outside, IsEmptyForHealthySurfaces) {
  for (const test::Shape& shape : {test::icosphere(3), test::torus(9, 6), test::disk(4)}) {
    const Json stored = certified(shape.data, shape.name);
    EXPECT_EQ(stored["verified"], shape.data.triangles.size());
    EXPECT_EQ(stored["triangles"], shape.data.triangles.size());
    for (const char* key : {"duplicates", "differing", "zeroArea", "reversed", "splitVertices"})
      EXPECT_EQ(stored[key], 0) << key;
  }
}

TEST(Outside, TrianglesWithoutAreaAreVerifiedAsTheyAreStored) {
  for (const test::Shape& shape : {test::icosphere(3), test::torus(9, 6), test::disk(5)}) {
    MeshData data = shape.data;
    for (const std::size_t f : {std::size_t{7}, std::size_t{20}}) {  // caps
      const auto t = data.triangles[f];
      const int m = static_cast<int>(data.positions.size());
      Vec3 middle;
      for (std::size_t n = 0; n < 3; ++n)
        middle[n] =
            (data.positions[std::size_t(t[0])][n] + data.positions[std::size_t(t[1])][n]) / 2;
      data.positions.push_back(middle);
      data.triangles[f] = {m, t[1], t[2]};
      data.triangles.push_back({t[0], m, t[2]});
      data.triangles.push_back({t[0], t[1], m});
    }
    const auto t = data.triangles[2];  // needles
    data.positions[std::size_t(t[0])] = data.positions[std::size_t(t[1])];
    const Json stored = certified(data, shape.name);
    EXPECT_EQ(stored["verified"], data.triangles.size()) << shape.name;
    EXPECT_EQ(stored["zeroArea"], 0);
  }
}

TEST(Outside, CopiesHaveTheUvOfTheirTwins) {
  MeshData data = test::icosphere(3).data;
  const MeshData once = data;
  for (const auto& t : once.triangles) data.triangles.push_back({t[1], t[0], t[2]});
  data.triangles.push_back(once.triangles[3]);
  const Json stored = certified(data, "double-sided");
  EXPECT_EQ(stored["verified"], once.triangles.size());
  EXPECT_EQ(stored["duplicates"], once.triangles.size() + 1);
  EXPECT_EQ(stored["differing"], 0);
  EXPECT_EQ(stored["triangles"], data.triangles.size());
}

TEST(Outside, TrianglesWithoutSurfaceAndFlippedOnesAreCounted) {
  MeshData data = test::icosphere(3).data;
  const int first = static_cast<int>(data.positions.size());
  data.triangles.push_back({data.triangles[0][0], data.triangles[0][0], data.triangles[0][1]});
  for (int n = 0; n < 3; ++n) data.positions.push_back({4, 4, 4});
  data.triangles.push_back({first, first + 1, first + 2});
  for (const std::size_t f : {3, 4, 11}) std::swap(data.triangles[f][0], data.triangles[f][1]);
  const Json stored = certified(data, "mixed");
  EXPECT_EQ(stored["zeroArea"], 2);
  EXPECT_EQ(stored["reversed"], 3);
  EXPECT_EQ(stored["verified"], data.triangles.size() - 2);
}

TEST(Outside, VerticesThatWereSplitAreCounted) {
  // Two spheres that share one vertex.
  MeshData data = test::icosphere(2).data;
  const MeshData once = data;
  const int first = static_cast<int>(data.positions.size());
  for (const Vec3& p : once.positions) data.positions.push_back({p[0] + 5, p[1], p[2]});
  for (const auto& t : once.triangles) {
    std::array<int, 3> moved{};
    for (std::size_t k = 0; k < 3; ++k) moved[k] = t[k] == 0 ? 0 : t[k] + first;
    data.triangles.push_back(moved);
  }
  const Json stored = certified(data, "pinched");
  EXPECT_EQ(stored["splitVertices"], 1);
  EXPECT_EQ(stored["verified"], data.triangles.size());
}

TEST(Outside, ConesAtAVertexOfTwoPartsSayWhichPartIsMeant) {
  // Two cubes that share a corner, which is a cone of both.
  MeshData data = test::cube(2).data;
  const MeshData once = data;
  const int first = static_cast<int>(data.positions.size());
  for (const Vec3& p : once.positions) data.positions.push_back({-p[0], -p[1], p[2]});
  for (const auto& t : once.triangles) {
    std::array<int, 3> moved{};
    for (std::size_t k = 0; k < 3; ++k) moved[k] = t[k] == 0 ? 0 : t[k] + first;
    data.triangles.push_back(moved);
  }
  const auto& p = once.positions[0];
  for (std::size_t v = static_cast<std::size_t>(first); v < data.positions.size(); ++v)
    for (std::size_t n = 0; n < 2; ++n) data.positions[v][n] += 2 * p[n];
  Session session = loaded("mesh.obj", io::writePlainObj(data, {}, ""));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  ASSERT_TRUE(session.isCertified());
  const std::string cones = session.conesJson();
  std::set<int> triangles;
  const Json told = Json::parse(cones);
  for (const Json& cone : told["cones"])
    if (cone["vertex"] == 0) triangles.insert(cone.at("triangle").get<int>());
  ASSERT_EQ(triangles.size(), 2u) << cones;
  EXPECT_LT(*triangles.begin(), static_cast<int>(once.triangles.size()));
  EXPECT_GE(*triangles.rbegin(), static_cast<int>(once.triangles.size()));
  // Given back, they give the same map.
  const std::vector<double> uv = session.uv();
  Result<prescription::Prescription> given = readPrescription("cones.json", cones, 0);
  ASSERT_TRUE(given);
  ASSERT_TRUE(session.parametrize(*given, {}));
  EXPECT_EQ(session.uv(), uv);
  given->cones[0].triangle = 1'000'000;
  const Status refused = session.parametrize(*given, {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kPrescription);
}

TEST(Outside, AMeshWithNothingLeftIsRefused) {
  MeshData data = test::icosphere(2).data;
  for (Vec3& p : data.positions) p = {1, 2, 3};
  Session session = loaded("mesh.obj", io::writePlainObj(data, {}, ""));
  const Status solved = session.parametrize(std::nullopt, {});
  ASSERT_FALSE(solved);
  EXPECT_EQ(solved.error().code, ErrorCode::kUnsupported);
  EXPECT_NE(solved.error().message.find("nothing is left to parametrize"), std::string::npos);
  EXPECT_FALSE(session.isCertified());
  EXPECT_FALSE(session.verify(std::nullopt, {}));
}

}  // namespace
}  // namespace hgp::api
