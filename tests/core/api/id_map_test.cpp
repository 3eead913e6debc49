#include "hgp/api/model/id_map.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace hgp::api {
namespace {

TEST(IdMap, NoneStaysNoneThroughAChainOfMaps) {
  const IdMap<VertexId, MeshVertexId> first({2, -1, 0});
  const IdMap<MeshVertexId, SurfaceVertexId> second({5, 6, -1});
  const IdMap<VertexId, SurfaceVertexId> both = first.then(second);
  ASSERT_EQ(both.size(), 3);
  EXPECT_EQ(both[VertexId{0}], SurfaceVertexId{});
  EXPECT_EQ(both[VertexId{1}], SurfaceVertexId{});
  EXPECT_EQ(both[VertexId{2}], SurfaceVertexId{5});
  EXPECT_EQ(both[VertexId{}], SurfaceVertexId{});
}

TEST(IdMap, TheIdentityChangesNothing) {
  const IdMap<MeshFaceId, SurfaceFaceId> way({4, 1, 3});
  const auto same = IdMap<FaceId, MeshFaceId>::identity(3).then(way);
  EXPECT_EQ(same.raw(), way.raw());
  EXPECT_TRUE(same.has(FaceId{2}) && !same.has(FaceId{3}) && !same.has(FaceId{}));
}

TEST(IdMap, OnlyIdsOfItsOwnTypeAreIndices) {
  using Way = IdMap<MeshVertexId, SurfaceVertexId>;
  EXPECT_TRUE((std::is_invocable_v<decltype(&Way::operator[]), Way, MeshVertexId>));
  EXPECT_FALSE((std::is_invocable_v<decltype(&Way::operator[]), Way, VertexId>));
}

}  // namespace
}  // namespace hgp::api
