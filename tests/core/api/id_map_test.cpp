#include "hgp/api/model/id_map.h"

#include <gtest/gtest.h>

#include <type_traits>
#include <vector>

#include "hgp/api/model/model.h"

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

TEST(ToSurfaceIds, EveryKindOfPlaceHasItsOwnMap) {
  using Kind = Where::Kind;
  ModelComponent component;
  component.vertex = IdMap<VertexId, SurfaceVertexId>({10, 11, 12});
  component.face = IdMap<FaceId, SurfaceFaceId>({20, 21, 22});
  component.loop = IdMap<LoopId, SurfaceLoopId>({30, 31, 32});
  std::vector<Where> where{{Kind::kVertex, 1}, {Kind::kEdge, 2, 0}, {Kind::kFace, 1},
                           {Kind::kLoop, 2},   {Kind::kLine, 1},    {Kind::kByte, 2},
                           {Kind::kFace, 3}};
  toSurfaceIds(component, where);
  EXPECT_EQ(where, (std::vector<Where>{{Kind::kVertex, 11},
                                       {Kind::kEdge, 12, 10},
                                       {Kind::kFace, 21},
                                       {Kind::kLoop, 32},
                                       {Kind::kLine, 1},
                                       {Kind::kByte, 2},
                                       {Kind::kFace, 3}}))
      << "lines, bytes and ids beyond the component stay";
}

}  // namespace
}  // namespace hgp::api
