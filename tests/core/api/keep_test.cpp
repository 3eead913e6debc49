// Results that are kept go with every file that has their surface, and with no other.
#include <gtest/gtest.h>

#include <cmath>

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

TEST(KeptResults, ApplyToEveryFileWithTheSameSurface) {
  const MeshData ball = test::icosphere(3).data, ring = test::torus(9, 6).data;
  Session session;
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  session.keep("ball");
  const std::string map = written(session);
  ASSERT_TRUE(session.load(fileOf(ring), {}));
  EXPECT_FALSE(session.hasResult());
  EXPECT_FALSE(session.recall("ball")) << "it is a map of another surface";
  EXPECT_FALSE(session.hasResult());
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  session.keep("ring");
  // The same surface in a file with other bytes.
  ASSERT_TRUE(session.load(fileOf(ball, "another file"), {}));
  EXPECT_FALSE(session.recall("ring"));
  ASSERT_TRUE(session.recall("ball"));
  EXPECT_TRUE(session.isCertified());
  const std::string again = written(session);
  EXPECT_TRUE(again != map);
  EXPECT_TRUE(again.substr(again.find("vt ")) == map.substr(map.find("vt ")));
  ASSERT_TRUE(session.load(fileOf(ring), {}));
  EXPECT_TRUE(session.recall("ring"));
}

TEST(KeptResults, RequireTheSamePositionsTrianglesAndRepairs) {
  const MeshData ball = test::icosphere(2).data;
  MeshData moved = ball, turned = ball, fewer = ball;
  moved.positions[5][0] = std::nextafter(moved.positions[5][0], 9.0);
  std::swap(turned.triangles[0], turned.triangles[1]);
  fewer.triangles.pop_back();
  Session session;
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  session.keep("ball");
  for (const MeshData* other : {&moved, &turned, &fewer}) {
    ASSERT_TRUE(session.load(fileOf(*other), {}));
    EXPECT_FALSE(session.recall("ball"));
  }
  LoadOptions welded;
  welded.weld = 0.8;
  ASSERT_TRUE(session.load(fileOf(ball), welded));
  EXPECT_FALSE(session.recall("ball"));
  ASSERT_TRUE(session.load(fileOf(ball), {}));
  EXPECT_TRUE(session.recall("ball"));
}

TEST(KeptResults, AreAtMostTwoPerSurface) {
  const MeshData ball = test::icosphere(2).data, ring = test::torus(9, 6).data;
  Session session;
  for (const MeshData* mesh : {&ball, &ring}) {
    ASSERT_TRUE(session.load(fileOf(*mesh), {}));
    for (const char* name : {"first", "second", "third"}) {
      ASSERT_TRUE(session.parametrize(std::nullopt, {}));
      session.keep((mesh == &ball ? "ball " : "ring ") + std::string(name));
    }
  }
  for (const MeshData* mesh : {&ball, &ring}) {
    ASSERT_TRUE(session.load(fileOf(*mesh), {}));
    const std::string of = mesh == &ball ? "ball " : "ring ";
    EXPECT_FALSE(session.recall(of + "first"));
    EXPECT_TRUE(session.recall(of + "second"));
    EXPECT_TRUE(session.recall(of + "third"));
  }
}

TEST(KeptResults, AFailedLoadLeavesEverythingAsItWas) {
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
