#include <gtest/gtest.h>

#include <cmath>

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

}  // namespace
}  // namespace hgp::api
