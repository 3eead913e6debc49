// Sets of triangles grown by rings.  Laws: a ring adds what shares a vertex; patches that meet are one.
#include "hgp/mesh/face_rings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"

namespace hgp {
namespace {

TEST(GrowFaces, AddsTheFacesThatTouchARingAtATime) {
  const TriMesh mesh = test::disk(6).mesh();
  const std::vector<FaceId> one{FaceId(0)};
  EXPECT_EQ(growFaces(mesh, one, 0), one);
  const std::vector<FaceId> first = growFaces(mesh, one, 1);
  for (FaceId f : mesh.faces()) {
    bool touches = false;
    for (VertexId v : mesh.corners(f))
      for (VertexId w : mesh.corners(FaceId(0))) touches |= v == w;
    EXPECT_EQ(std::binary_search(first.begin(), first.end(), f), touches);
  }
  EXPECT_EQ(growFaces(mesh, one, 2), growFaces(mesh, first, 1));
  EXPECT_EQ(growFaces(mesh, one, 20).size(), static_cast<std::size_t>(mesh.faceCount()));
}

TEST(PatchesAround, AreApartWhereTheirRingsDoNotMeet) {
  const TriMesh mesh = test::grid(40, 4).mesh();
  const FaceId first(0), last(mesh.faceCount() - 1);
  for (int rings : {0, 3, 12, 30}) {
    const auto patches = patchesAround(mesh, {first, last}, rings);
    const std::vector<FaceId> all = growFaces(mesh, {first, last}, rings);
    std::size_t count = 0;
    for (const std::vector<FaceId>& patch : patches) {
      EXPECT_TRUE(std::is_sorted(patch.begin(), patch.end()));
      EXPECT_TRUE(std::includes(all.begin(), all.end(), patch.begin(), patch.end()));
      count += patch.size();
    }
    EXPECT_EQ(count, all.size()) << rings;
    EXPECT_EQ(patches.size(), rings < 18 ? 2u : 1u) << rings;
    EXPECT_EQ(patches[0] == growFaces(mesh, {first}, rings), patches.size() == 2u) << rings;
  }
  EXPECT_TRUE(patchesAround(mesh, {}, 6).empty());
}

}  // namespace
}  // namespace hgp
