// Patches around triangles.  Laws: a patch holds what lies within its rings; patches that meet are one.
#include "hgp/grid/repair_change.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"

namespace hgp {
namespace {

TEST(PatchesAround, AreApartWhereTheirRingsDoNotMeet) {
  const TriMesh mesh = test::grid(40, 4).mesh();
  const FaceId first(0), last(mesh.faceCount() - 1);
  for (int rings : {0, 3, 12, 30}) {
    const auto patches = patchesAround(mesh, {first, last}, rings);
    const std::vector<FaceId> all = facesAround(mesh, {first, last}, rings);
    std::size_t count = 0;
    for (const std::vector<FaceId>& patch : patches) {
      EXPECT_TRUE(std::is_sorted(patch.begin(), patch.end()));
      EXPECT_TRUE(std::includes(all.begin(), all.end(), patch.begin(), patch.end()));
      count += patch.size();
    }
    EXPECT_EQ(count, all.size()) << rings;
    EXPECT_EQ(patches.size(), rings < 18 ? 2u : 1u) << rings;
    EXPECT_EQ(patches[0] == facesAround(mesh, {first}, rings), patches.size() == 2u) << rings;
  }
  EXPECT_TRUE(patchesAround(mesh, {}, 6).empty());
}

}  // namespace
}  // namespace hgp
