// Maps of several meshes of one glTF, written at once.
#include "hgp/api/file_maps.h"

#include <gtest/gtest.h>

#include <cstring>
#include <nlohmann/json.hpp>

namespace hgp::api {
namespace {

using Json = nlohmann::json;

/// A tetrahedron, twice as large with `scale` 2: positions, then indices.
io::Bytes tetrahedronBytes(float scale) {
  const float positions[] = {0, 0, 0, scale, 0, 0, 0, scale, 0, 0, 0, scale};
  const std::uint16_t indices[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
  io::Bytes bytes(sizeof positions + sizeof indices);
  std::memcpy(bytes.data(), positions, sizeof positions);
  std::memcpy(bytes.data() + sizeof positions, indices, sizeof indices);
  return bytes;
}

/// A .gltf of `count` meshes, all with material 0; with `isShared` they read the same accessors of the same bytes.
Json manyMeshes(int count, bool isShared) {
  Json json = Json::parse(R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data.bin"}],
    "textures": [{}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "texCoord": 1}}}]})");
  for (int m = 0; m < count; ++m) {
    const int first = isShared ? 0 : 2 * m;
    json["meshes"].push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", first}}}, {"indices", first + 1}, {"material", 0}}}}});
    if (m > 0 && isShared) continue;
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72 * m}, {"byteLength", 48}});
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 72 * m + 48}, {"byteLength", 24}});
    json["accessors"].push_back({{"bufferView", first},
                                 {"componentType", 5126},
                                 {"count", 4},
                                 {"type", "VEC3"},
                                 {"min", {0, 0, 0}},
                                 {"max", {m + 1, m + 1, m + 1}}});
    json["accessors"].push_back(
        {{"bufferView", first + 1}, {"componentType", 5123}, {"count", 12}, {"type", "SCALAR"}});
  }
  json["buffers"][0]["byteLength"] = 72 * (isShared ? 1 : count);
  return json;
}

/// The files, with the number of times that a side file was read.
io::FileSet filesOfMany(const Json& json, int* reads = nullptr) {
  io::FileSet files;
  files.name = "many.gltf";
  files.main = io::asBytes(json.dump());
  files.resolve = [count = json["meshes"].size(), reads](const std::string&) {
    if (reads != nullptr) ++*reads;
    io::Bytes bytes;
    for (std::size_t m = 0; m < count; ++m) {
      const io::Bytes one = tetrahedronBytes(static_cast<float>(m + 1));
      bytes.insert(bytes.end(), one.begin(), one.end());
    }
    return Result<io::Bytes>(bytes);
  };
  return files;
}

/// The session with the file, and the maps of these meshes.
FileMaps mapsOf(Session& session, const std::vector<int>& which, WriteOptions options) {
  options.name = "out.gltf";
  FileMaps maps(options);
  for (const int mesh : which) {
    Status done = session.choose(mesh);
    if (done) done = session.parametrize(std::nullopt, {});
    if (done) done = maps.add(session);
    EXPECT_TRUE(done) << (done ? "" : done.error().message);
  }
  return maps;
}

/// Whether every mesh of what was written is certified.
void expectAllCertified(const io::Written& written, const io::FileSet& original) {
  io::FileSet files;
  files.name = written.files[0].name;
  files.main = written.files[0].bytes;
  files.resolve = [&](const std::string& name) -> Result<io::Bytes> {
    for (const io::OutputFile& file : written.files)
      if (file.name == name) return file.bytes;
    return original.resolve(name);
  };
  Session session;
  ASSERT_TRUE(session.load(std::move(files), {}));
  for (int mesh = 0; mesh < session.surfaceCount(); ++mesh) {
    ASSERT_TRUE(session.choose(mesh));
    const Result<Verdict> verdict = session.verify(std::nullopt, {});
    ASSERT_TRUE(verdict);
    EXPECT_TRUE(verdict->isGood) << mesh;
  }
}

TEST(FileMaps, AFileIsReadOnceAndGetsOneSideFileHoweverManyMeshesItHas) {
  int reads = 0;
  Session session;
  ASSERT_TRUE(session.load(filesOfMany(manyMeshes(20, false), &reads), {}));
  std::vector<int> all(20);
  for (int m = 0; m < 20; ++m) all[static_cast<std::size_t>(m)] = m;
  const Result<WrittenFile> written = mapsOf(session, all, {}).write();
  ASSERT_TRUE(written);
  EXPECT_EQ(reads, 1);
  EXPECT_TRUE(written->isCertified);
  ASSERT_EQ(written->files.size(), 2U);
  EXPECT_EQ(written->files[1].name, "out-uv.bin");
  EXPECT_EQ(written->mapNotes.size(), 20U);
  expectAllCertified(*written, filesOfMany(manyMeshes(20, false)));
}

TEST(FileMaps, MeshesWithSharedAccessorsGetTheirOwnAndNoneIsLeftUnread) {
  Session session;
  ASSERT_TRUE(session.load(filesOfMany(manyMeshes(3, true)), {}));
  const Result<WrittenFile> written = mapsOf(session, {0, 1, 2}, {}).write();
  ASSERT_TRUE(written);
  expectAllCertified(*written, filesOfMany(manyMeshes(3, true)));
  const Json json = Json::parse(written->files[0].bytes);
  std::vector<int> readers(json["accessors"].size());
  for (const Json& mesh : json["meshes"]) {
    const Json& primitive = mesh["primitives"][0];
    ++readers[primitive["indices"].get<std::size_t>()];
    for (const Json& index : primitive["attributes"]) ++readers[index.get<std::size_t>()];
  }
  for (const int count : readers) EXPECT_GT(count, 0);
}

TEST(FileMaps, AMaterialIsCopiedOnceWhereMeshesWithoutAMapUseIt) {
  WriteOptions options;
  options.pointsMaterials = true;
  Session session;
  ASSERT_TRUE(session.load(filesOfMany(manyMeshes(4, false)), {}));
  const auto materials = [&](const std::vector<int>& which) {
    const Result<WrittenFile> written = mapsOf(session, which, options).write();
    EXPECT_TRUE(written);
    return written ? Json::parse(written->files[0].bytes) : Json();
  };
  const auto setOf = [](const Json& material) {
    return material["pbrMetallicRoughness"]["baseColorTexture"]["texCoord"].get<int>();
  };
  const Json some = materials({0, 2});
  ASSERT_EQ(some["materials"].size(), 2U);
  EXPECT_EQ(setOf(some["materials"][0]), 1);
  EXPECT_EQ(setOf(some["materials"][1]), 0);
  for (std::size_t m = 0; m < 4; ++m)
    EXPECT_EQ(some["meshes"][m]["primitives"][0]["material"], m % 2 == 0 ? 1 : 0);
  const Json all = materials({0, 1, 2, 3});
  ASSERT_EQ(all["materials"].size(), 1U);
  EXPECT_EQ(setOf(all["materials"][0]), 0);
}

TEST(FileMaps, MeshesShareThePictureOfAGrid) {
  WriteOptions options;
  options.gridTiles = 0;
  Session session;
  ASSERT_TRUE(session.load(filesOfMany(manyMeshes(3, false)), {}));
  const Result<WrittenFile> written = mapsOf(session, {0, 1, 2}, options).write();
  ASSERT_TRUE(written);
  const Json json = Json::parse(written->files[0].bytes);
  EXPECT_EQ(json["images"].size(), 1U);
  EXPECT_EQ(json["materials"].size(), 4U);
  for (std::size_t m = 0; m < 3; ++m)
    EXPECT_EQ(json["meshes"][m]["primitives"][0]["material"], m + 1);
}

TEST(FileMaps, SessionsThatReadTheSameFileGiveTheSameBytesAndEachMapHasItsOwnOptions) {
  Session one;
  ASSERT_TRUE(one.load(filesOfMany(manyMeshes(2, false)), {}));
  const Result<WrittenFile> expected = mapsOf(one, {0, 1}, {}).write();
  ASSERT_TRUE(expected);
  WriteOptions options;
  options.name = "out.gltf";
  FileMaps maps(options), own(options);
  for (const int mesh : {0, 1}) {
    Session session;
    ASSERT_TRUE(session.load(filesOfMany(manyMeshes(2, false)), {}));
    ASSERT_TRUE(session.choose(mesh));
    ASSERT_TRUE(session.parametrize(std::nullopt, {}));
    ASSERT_TRUE(maps.add(session));
    WriteOptions other = options;
    other.uvSet = 2 * mesh;
    other.embedCones = mesh == 1;
    ASSERT_TRUE(own.add(session, other));
  }
  const Result<WrittenFile> written = maps.write(), mixed = own.write();
  ASSERT_TRUE(written);
  ASSERT_EQ(written->files.size(), expected->files.size());
  for (std::size_t i = 0; i < written->files.size(); ++i)
    EXPECT_TRUE(written->files[i].bytes == expected->files[i].bytes) << i;
  ASSERT_TRUE(mixed);
  const Json json = Json::parse(mixed->files[0].bytes);
  const Json &first = json["meshes"][0], &second = json["meshes"][1];
  EXPECT_FALSE(first["primitives"][0]["attributes"].contains("TEXCOORD_1"));
  EXPECT_TRUE(second["primitives"][0]["attributes"].contains("TEXCOORD_2"));
  EXPECT_FALSE(first.contains("extras"));
  EXPECT_TRUE(second.contains("extras"));
}

TEST(FileMaps, RefusesTwoMapsOfOneMeshMapsOfOtherFilesAndNone) {
  Session one, other;
  ASSERT_TRUE(one.load(filesOfMany(manyMeshes(2, false)), {}));
  ASSERT_TRUE(other.load(filesOfMany(manyMeshes(3, false)), {}));
  EXPECT_EQ(mapsOf(one, {1, 1}, {}).write().error().code, ErrorCode::kUsage);
  EXPECT_EQ(mapsOf(one, {}, {}).write().error().code, ErrorCode::kUsage);
  FileMaps maps = mapsOf(one, {0}, {});
  ASSERT_TRUE(other.choose(1));
  EXPECT_EQ(maps.add(other).error().code, ErrorCode::kUsage);
  ASSERT_TRUE(other.parametrize(std::nullopt, {}));
  ASSERT_TRUE(maps.add(other));
  EXPECT_EQ(maps.write().error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace hgp::api
