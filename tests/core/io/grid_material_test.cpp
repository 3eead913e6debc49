#include "hgp/io/grid_material.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hgp/io/uv_layout.h"

namespace hgp::io {
namespace {

using Json = nlohmann::json;

std::string plainText(const Bytes& bytes) { return {bytes.begin(), bytes.end()}; }

std::vector<OutputFile> one(const std::string& name, const std::string& text) {
  return {{name, asBytes(text)}};
}

TEST(GridMaterial, AnObjGetsALibraryAndEveryOtherLineStays) {
  const std::string text = "# a\nmtllib old.mtl\nv 0 0 0\n\tusemtl  wood\nf 1 2 3\nusemtl steel";
  const auto made = withGridMaterial(one("dir/a b.obj", text), "obj", {3.0, 0, -1});
  ASSERT_TRUE(made);
  ASSERT_EQ(made->size(), 3U);
  EXPECT_EQ(plainText((*made)[0].bytes),
            "mtllib a_b.grid.mtl\nusemtl hgp_grid\n# a\n# mtllib old.mtl\nv 0 0 0\n# \tusemtl  "
            "wood\nf 1 2 3\n# usemtl steel");
  EXPECT_EQ((*made)[1].name, "a_b.grid.mtl");
  EXPECT_NE(plainText((*made)[1].bytes).find("map_Kd -s 1.5 1.5 1 a_b.grid.png\n"),
            std::string::npos);
  EXPECT_EQ((*made)[2].name, "a_b.grid.png");
  EXPECT_EQ(plainText((*made)[2].bytes).substr(1, 3), "PNG");
}

TEST(GridMaterial, AGltfGetsItOnPrimitivesWithTheUvSetAndKeepsItsNumbers) {
  const std::string text =
      R"({"asset":{"version":"2.0","x":1.50,"id":9007199254740993},"extensionsUsed":["A"],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]},{"primitives":[)"
      R"({"attributes":{"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_1":1},"material":0},)"
      R"({"attributes":{"POSITION":0}}]}],"materials":[{"name":"wood"}]})";
  const auto made = withGridMaterial(one("a.gltf", text), "gltf", {8.0, 1, -1});
  ASSERT_TRUE(made);
  const std::string out = plainText(made->front().bytes);
  EXPECT_NE(out.find(R"("x":1.50,"id":9007199254740993)"), std::string::npos);
  const Json json = Json::parse(out);
  const Json& primitives = json["meshes"][1]["primitives"];
  EXPECT_EQ(primitives[0]["material"], 1);
  EXPECT_FALSE(primitives[1].contains("material"));
  EXPECT_FALSE(json["meshes"][0]["primitives"][0].contains("material"));
  const Json& texture = json["materials"][1]["pbrMetallicRoughness"]["baseColorTexture"];
  EXPECT_EQ(texture["texCoord"], 1);
  EXPECT_EQ(texture["extensions"]["KHR_texture_transform"]["scale"], Json::parse("[4,4]"));
  EXPECT_EQ(json["extensionsUsed"], Json::parse(R"(["A","KHR_texture_transform"])"));
  EXPECT_EQ(json["images"][0]["uri"].get<std::string>().substr(0, 22), "data:image/png;base64,");
}

TEST(GridMaterial, MaterialsOfSeveralMeshesShareOnePicture) {
  const std::string text =
      R"({"asset":{"version":"2.0"},"meshes":[{"primitives":[{"attributes":{"TEXCOORD_0":0}}]},)"
      R"({"primitives":[{"attributes":{"TEXCOORD_0":1}}]}]})";
  const auto made = withGridMaterials(one("a.gltf", text), {{2.0, 0, -1}, {8.0, 1, -1}});
  ASSERT_TRUE(made);
  const Json json = Json::parse(plainText(made->front().bytes));
  ASSERT_EQ(json["images"].size(), 1U);
  ASSERT_EQ(json["materials"].size(), 2U);
  for (std::size_t m = 0; m < 2; ++m) {
    EXPECT_EQ(json["meshes"][m]["primitives"][0]["material"], m);
    const Json& texture = json["materials"][m]["pbrMetallicRoughness"]["baseColorTexture"];
    EXPECT_EQ(texture["index"], 0);
    EXPECT_EQ(texture["extensions"]["KHR_texture_transform"]["scale"][0], m == 0 ? 1 : 4);
  }
}

TEST(GridMaterial, ReportsWhereNoneIsPossible) {
  EXPECT_EQ(withGridMaterial(one("a.ply", "ply"), "ply", {}).error().code, ErrorCode::kUnsupported);
  EXPECT_EQ(withGridMaterial(one("a.gltf", R"({"meshes":[]})"), "gltf", {}).error().code,
            ErrorCode::kUsage);
  EXPECT_FALSE(withGridMaterial(one("a.gltf", "{"), "gltf", {}));
  const auto empty = withGridMaterial(one("a.obj", ""), "obj", {});
  ASSERT_TRUE(empty);
  EXPECT_EQ(plainText(empty->front().bytes), "mtllib a.grid.mtl\nusemtl hgp_grid\n");
}

UvMap square() { return {{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}}; }

TEST(UvLayout, TheDrawingHasEveryEdgeOnceUpright) {
  const std::string svg = plainText(uvLayoutSvg(square(), {{0, 1}}));
  std::size_t lines = 0;
  for (const char c : svg) lines += c == 'M';
  EXPECT_EQ(lines, 6U);  // five edges and a seam
  EXPECT_NE(svg.find("viewBox=\"-5 -5 1010 510\""), std::string::npos);
  EXPECT_NE(svg.find("M0 500L1000 500"), std::string::npos);  // v = 0 is at the bottom
  EXPECT_NE(plainText(uvLayoutSvg({}, {})).find("viewBox=\"-5 -5 10 10\""), std::string::npos);
}

TEST(UvLayout, TheFlatMeshLiesOnItsOwnUv) {
  EXPECT_EQ(plainText(flatObj(square(), "hgp")),
            "# hgp: the map laid flat\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nvt 0 0\nvt 2 0\nvt 2 1\n"
            "vt 0 1\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
}

}  // namespace
}  // namespace hgp::io
