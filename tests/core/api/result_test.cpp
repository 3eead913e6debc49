// Stored results go with every file that has their surface, and with no other.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hgp/api/session.h"
#include "support/shapes.h"

namespace hgp::api {
namespace {

io::FileSet fileOf(const MeshData& mesh, const std::string& comment = "") {
  io::FileSet files;
  files.name = "mesh.obj";
  files.main = io::writePlainObj(mesh, {}, comment);
  return files;
}

std::string written(const Session& session) {
  Result<WrittenMap> made = session.write({});
  EXPECT_TRUE(made.hasValue());
  return made ? std::string(made->files[0].bytes.begin(), made->files[0].bytes.end()) : "";
}

TEST(StoredResults, ApplyToEveryFileWithTheSameSurface) {
  const MeshData ball = test::icosphere(3).data, ring = test::torus(9, 6).data;
  Session session;
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  EXPECT_FALSE(session.use(session.result())) << "there is none";
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const StoredResult ofBall = session.result();
  const std::string map = written(session);
  ASSERT_TRUE(session.load(fileOf(ring), {}));
  EXPECT_FALSE(session.hasResult());
  EXPECT_FALSE(session.use(ofBall)) << "it is a map of another surface";
  EXPECT_FALSE(session.hasResult());
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const StoredResult ofRing = session.result();
  // The same surface in a file with other bytes, in another session.
  Session other;
  ASSERT_TRUE(other.load(fileOf(ball, "another file"), {}));
  EXPECT_FALSE(other.use(ofRing));
  ASSERT_TRUE(other.use(ofBall));
  EXPECT_TRUE(other.isCertified());
  const std::string again = written(other);
  EXPECT_TRUE(again != map);
  EXPECT_TRUE(again.substr(again.find("vt ")) == map.substr(map.find("vt ")));
  ASSERT_TRUE(session.load(fileOf(ring), {}));
  EXPECT_TRUE(session.use(ofRing));
}

TEST(StoredResults, RequireTheSamePositionsTrianglesAndRepairs) {
  const MeshData ball = test::icosphere(2).data;
  MeshData moved = ball, turned = ball, fewer = ball;
  moved.positions[5][0] = std::nextafter(moved.positions[5][0], 9.0);
  std::swap(turned.triangles[0], turned.triangles[1]);
  fewer.triangles.pop_back();
  Session session;
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const StoredResult result = session.result();
  for (const MeshData* other : {&moved, &turned, &fewer}) {
    ASSERT_TRUE(session.load(fileOf(*other), {}));
    EXPECT_FALSE(session.use(result));
  }
  LoadOptions welded;
  welded.weld = 0.8;
  ASSERT_TRUE(session.load(fileOf(ball), welded));
  EXPECT_FALSE(session.use(result));
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  EXPECT_TRUE(session.use(result));
}

TEST(StoredResults, AreAsManyAsAreHeldAndOutliveTheirSession) {
  Session again;
  ASSERT_TRUE(again.load(fileOf(test::icosphere(2).data), {}));
  std::vector<std::pair<StoredResult, std::string>> made;
  {
    Session session;
    ASSERT_TRUE(session.load(fileOf(test::icosphere(2).data), {}));
    for (const int q : {4, 2, 6, 3}) {
      SolveOptions options;
      options.q = q;
      ASSERT_TRUE(session.parametrize(std::nullopt, options));
      made.emplace_back(session.result(), written(session));
    }
    for (const auto& [result, map] : made) {
      ASSERT_TRUE(session.use(result));
      EXPECT_EQ(written(session), map);
    }
  }
  for (const auto& [result, map] : made) {
    ASSERT_TRUE(again.use(result));
    EXPECT_EQ(written(again), map);
  }
}

TEST(StoredResults, AFailedLoadLeavesEverythingAsItWas) {
  Session session;
  ASSERT_TRUE(session.load(fileOf(test::icosphere(2).data), {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const std::string map = written(session);
  io::FileSet broken;
  broken.name = "broken.obj";
  const std::string text = "v 0 0 0\nf 1 2 3\n";
  broken.main.assign(text.begin(), text.end());
  EXPECT_FALSE(session.load(std::move(broken), {}));
  EXPECT_EQ(written(session), map);
  EXPECT_TRUE(session.parametrize(std::nullopt, {}));
}

}  // namespace
}  // namespace hgp::api
