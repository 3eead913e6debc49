#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

Session opened(const MeshData& mesh) {
  Session session;
  EXPECT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, {}));
  return session;
}

TEST(Measure, HasAValueForEveryTriangleAndEverySeamEdge) {
  const MeshData mesh = test::icosphere(3).data;
  Session session = opened(mesh);
  EXPECT_EQ(session.measure().error().code, ErrorCode::kUsage);
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const auto measures = session.measure();
  ASSERT_TRUE(measures);
  EXPECT_EQ(measures->stretch.size(), mesh.triangles.size());
  EXPECT_EQ(measures->logArea.size(), mesh.triangles.size());
  for (const float x : measures->stretch) EXPECT_GE(x, 1.0F);
  EXPECT_TRUE(measures->notPositive.empty());  // it is certified
  EXPECT_EQ(measures->seamChain.size(), session.seams().size());
  EXPECT_GT(measures->uvArea, 0);
}

TEST(Measure, FacesThatARepairFlippedOrLeftOutAreNotFolded) {
  MeshData mesh = test::icosphere(2).data;
  for (std::size_t f : {3U, 17U}) std::swap(mesh.triangles[f][1], mesh.triangles[f][2]);
  auto [a, b, c] = mesh.triangles[40];
  mesh.triangles.push_back({a, c, b});  // a copy, wound the other way
  Session session = opened(mesh);
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  ASSERT_TRUE(session.isCertified());
  EXPECT_TRUE(session.measure()->notPositive.empty());
}

TEST(Loops, AreClosedAndNumberedAsAPrescriptionNumbersThem) {
  const Session session = opened(test::puncturedTorus(12, 9).data);
  const auto loops = session.loops();
  ASSERT_TRUE(loops);
  ASSERT_EQ(loops->handles.size(), 2U);
  for (const auto& handle : loops->handles) EXPECT_GT(handle.size(), 2U);
  ASSERT_EQ(loops->boundaries.size(), 1U);
  EXPECT_GE(loops->boundaries[0].size(), 3U);
  EXPECT_TRUE(opened(test::icosphere(2).data).loops()->handles.empty());
  EXPECT_FALSE(Session().loops());
}

TEST(Measure, AreasAndOverlapsAreThoseOfTheCertificate) {
  // Two components of different size and shape.
  MeshData mesh = test::jittered(test::icosphere(4), 0.05).data;
  const auto first = static_cast<int>(mesh.positions.size());
  const MeshData other = test::torus(12, 9).data;
  for (const Vec3& p : other.positions)
    mesh.positions.push_back({7 * p[0] + 30, 7 * p[1], 11 * p[2]});
  const std::size_t ofFirst = mesh.triangles.size();
  for (const auto& t : other.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  Session session;
  ASSERT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const Result<MapMeasures> measures = session.measure();
  ASSERT_TRUE(measures);
  const auto certificate = nlohmann::json::parse(session.certificateJson());
  ASSERT_EQ(certificate["components"].size(), 2U);
  for (std::size_t p = 0; p < 2; ++p) {
    const auto begin = measures->logArea.begin() + (p == 0 ? 0 : static_cast<long>(ofFirst));
    const auto end = p == 0 ? begin + static_cast<long>(ofFirst) : measures->logArea.end();
    const auto& distortion = certificate["components"][p]["distortion"];
    EXPECT_NEAR(*std::min_element(begin, end), distortion["minLogArea"].get<double>(), 1e-5);
    EXPECT_NEAR(*std::max_element(begin, end), distortion["maxLogArea"].get<double>(), 1e-5);
  }
  const double share = certificate["overlap"]["share"];
  double most = 0;
  for (const auto& component : certificate["components"]) {
    most = std::max(most, component["overlap"]["share"].get<double>());
  }
  EXPECT_EQ(share, most);
  WriteOptions options;
  options.name = "out.obj";
  const Result<WrittenMap> written = session.write(options);
  ASSERT_TRUE(written);
  io::FileSet files;
  files.name = "out.obj";
  files.main = written->files[0].bytes;
  Session again;
  ASSERT_TRUE(again.load(std::move(files), {}));
  const Result<Verdict> verdict = again.verify(std::nullopt, {});
  ASSERT_TRUE(verdict);
  EXPECT_EQ(nlohmann::json::parse(verdict->json)["overlap"], certificate["overlap"]);
}

TEST(Measure, VerifyingWithTheConesOfAnotherSurfaceSaysSo) {
  MeshData mesh = test::icosphere(3).data;
  Session session;
  ASSERT_TRUE(session.loadArrays(mesh.positions, mesh.triangles, {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const auto cones = readPrescription("cones.json", session.conesJson(), 0);
  ASSERT_TRUE(cones);
  WriteOptions options;
  options.name = "out.obj";
  const Result<WrittenMap> written = session.write(options);
  ASSERT_TRUE(written);
  std::string text(written->files[0].bytes.begin(), written->files[0].bytes.end());
  const auto verified = [&] {
    io::FileSet files;
    files.name = "out.obj";
    files.main.assign(text.begin(), text.end());
    Session again;
    EXPECT_TRUE(again.load(std::move(files), {}));
    const Result<Verdict> verdict = again.verify(*cones, {});
    EXPECT_TRUE(verdict);
    return nlohmann::json::parse(verdict->json);
  };
  EXPECT_FALSE(verified().contains("notes"));
  text.erase(text.rfind("f "));  // the last face
  const auto notes = verified()["notes"];
  ASSERT_EQ(notes.size(), 2U) << notes;
  EXPECT_EQ(notes[0]["code"], "cones-other-triangles");
  EXPECT_EQ(notes[0]["numbers"], (nlohmann::json{{"asked", 180}, {"found", 179}}));
  EXPECT_EQ(notes[1]["code"], "cones-without-turning");
  EXPECT_EQ(notes[1]["numbers"]["loops"], 1);
}

}  // namespace
}  // namespace hgp::api
