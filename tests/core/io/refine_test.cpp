#include "hgp/mesh/refine.h"

#include "hgp/text/text.h"
#include "io_support.h"

namespace hgp::io {
namespace {

using test::openText;

DocumentPtr refinedText(const std::string& name, const std::string& text,
                        const std::vector<VertexPair>& edges) {
  Result<DocumentPtr> document = openText(name, text);
  EXPECT_TRUE(document.hasValue()) << (document ? "" : document.error().message);
  if (!document) return nullptr;
  Result<DocumentPtr> refined = (*document)->refined(0, edges);
  EXPECT_TRUE(refined.hasValue()) << (refined ? "" : refined.error().message);
  return refined ? std::move(*refined) : nullptr;
}

const char kQuads[] =
    "mtllib a.mtl\n"
    "v 0 0 0 1 0 0\nv 2 0 0 0 1 0\nv 2 2 0 0 0 1\nv 0 2 0 1 1 1\nv 4 0 0 0 0 0\nv 4 2 0 0 0 0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vn 1 0 0\nvn 0 1 0\n"
    "# hgp-cones {}\n"
    "usemtl red\n"
    "f 1/1/1 2/2/2 3/3/2  # first\n"
    "f 1/1/1 3/3/2 4/4/1\n"
    "usemtl blue\n"
    "f 2//1 5//1 6//1 3//1 # stays whole\n";

TEST(Refined, ObjKeepsItsLinesAndInterpolatesWhatVerticesAndCornersHave) {
  const DocumentPtr refined = refinedText("a.obj", kQuads, {{0, 2}, {0, 3}});
  ASSERT_TRUE(refined);
  const MeshData& mesh = refined->surfaces()[0].mesh;
  ASSERT_EQ(mesh.positions.size(), 8u);
  EXPECT_EQ(mesh.positions[6], (Vec3{1, 1, 0}));
  EXPECT_EQ(mesh.positions[7], (Vec3{0, 1, 0}));
  EXPECT_EQ(mesh.triangles.size(), 2u + 3u + 2u);
  const std::string text = test::written(*refined, test::vertexMap(mesh));
  for (const char* line :
       {"mtllib a.mtl\n", "usemtl red\n", "usemtl blue\n", "\nv 1 1 0 0.5 0 0.5\n",
        "\nv 0 1 0 1 0.5 0.5\n", "vn 0.707106781186547", "# stays whole"})
    EXPECT_NE(text.find(line), std::string::npos) << line << " is not in\n" << text;
  EXPECT_EQ(text.find("hgp-cones"), std::string::npos) << "cones of the mesh before";
  EXPECT_LT(text.find("v 1 1 0"), text.find("usemtl red")) << "defined before they are used";
  EXPECT_EQ(text.find("# first"), std::string::npos);
}

TEST(Refined, ObjHasTheMeansOfItsTextureCoordinates) {
  const std::string triangles = std::string(kQuads).substr(0, std::string(kQuads).find("usemtl b"));
  const DocumentPtr refined = refinedText("a.obj", triangles, {{0, 2}});
  ASSERT_TRUE(refined);
  const auto map = refined->existingUv(0, 0);
  ASSERT_TRUE(map.has_value());
  int means = 0;
  const MeshData& mesh = refined->surfaces()[0].mesh;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (mesh.triangles[t][k] == 6) {
        EXPECT_EQ(map->uv[std::size_t(map->cornerUv[t][k])], (Vec2{0.5, 0.5}));
        ++means;
      }
  EXPECT_EQ(means, 4);
}

TEST(Refined, ObjWithRelativeIndicesMeansTheSameVertices) {
  const DocumentPtr refined = refinedText(
      "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nf -3 \\\n -1 -2\r\nf -1 -2 -3",
      {{1, 2}});
  ASSERT_TRUE(refined);
  const MeshData& mesh = refined->surfaces()[0].mesh;
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[3], (Vec3{1, 1, 0}));
  EXPECT_EQ(mesh.positions[4], (Vec3{0.5, 0.5, 0}));
  EXPECT_EQ(mesh.triangles.size(), 6u);
}

TEST(Refined, OffAndPlyBecomeObjOfTheRefinedMesh) {
  const std::string off = "OFF\n4 2 0\n0 0 0\n2 0 0\n2 2 0\n0 2 0\n3 0 1 2\n3 0 2 3\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n2 0 0\n2 2 0\n0 2 0\n3 0 1 2\n3 0 2 3\n";
  for (const auto& [name, text] : {std::pair{"a.off", off}, std::pair{"a.ply", ply}}) {
    const DocumentPtr refined = refinedText(name, text, {{0, 2}});
    ASSERT_TRUE(refined);
    const MeshData& mesh = refined->surfaces()[0].mesh;
    EXPECT_EQ(mesh.triangles.size(), 4u) << name;
    const UvMap stored = refined->asStored(0, test::vertexMap(mesh));
    Result<DocumentPtr> again = openText("b.obj", test::written(*refined, stored));
    ASSERT_TRUE(again.hasValue());
    EXPECT_EQ((*again)->surfaces()[0].mesh.positions, mesh.positions) << name;
    EXPECT_EQ((*again)->surfaces()[0].mesh.triangles, mesh.triangles) << name;
  }
}

}  // namespace
}  // namespace hgp::io
