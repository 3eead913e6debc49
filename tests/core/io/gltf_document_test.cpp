#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "hgp/base/phrase.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/json/file.h"
#include "io_support.h"
#include "support/notes.h"

namespace hgp::io {
namespace {

using namespace test;

/// A square of two triangles as a .gltf with its data inside; `replace` edits the text.
std::string squareText(
    std::initializer_list<std::pair<std::string, std::string>> replacements = {}) {
  const float positions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
  Bytes bytes(sizeof positions + sizeof indices);
  std::memcpy(bytes.data(), positions, sizeof positions);
  std::memcpy(bytes.data() + sizeof positions, indices, sizeof indices);
  std::string text = R"({
  "asset" : { "version" : "2.0", "generator" : "by hand" },
  "buffers" : [ { "byteLength" : 60, "uri" : "data:;base64,BYTES" } ],
  "bufferViews" : [
    { "buffer" : 0, "byteLength" : 48 },
    { "buffer" : 0, "byteOffset" : 48, "byteLength" : 12 }
  ],
  "accessors" : [
    { "bufferView" : 0, "componentType" : 5126, "count" : 4, "type" : "VEC3",
      "min" : [ 0.0, 0, 0e0 ], "max" : [ 1.00, 1, 0 ] },
    { "bufferView" : 1, "componentType" : 5123, "count" : 6, "type" : "SCALAR" }
  ],
  "meshes" : [ { "primitives" : [ { "attributes" : { "POSITION" : 0 }, "indices" : 1 } ] } ],
  "extras" : [ 9007199254740993, null, 1e400, 0.10 ]
}
)";
  text.replace(text.find("BYTES"), 5, encodeBase64(bytes));
  for (const auto& [from, to] : replacements) {
    EXPECT_NE(text.find(from), std::string::npos) << from;
    text.replace(text.find(from), from.size(), to);
  }
  return text;
}

DocumentPtr opened(const std::string& text) {
  auto document = openText("square.gltf", text);
  EXPECT_TRUE(document.hasValue()) << (document ? "" : document.error().message);
  return document ? std::move(*document) : nullptr;
}

/// `after` without what follows in `parts`, which must be there in this order.
void expectOnlyInserted(const std::string& before, const std::string& after) {
  // Every byte of the old text is still there, in order.
  std::size_t at = 0;
  for (char c : after) {
    if (at < before.size() && c == before[at]) ++at;
  }
  EXPECT_EQ(at, before.size());
}

/// Three vertices (least, most, most), (0, 0, 0), (most, most, 0) of a type, four numbers apart.
template <class T>
std::string quantizedText(int componentType, bool isNormalized) {
  constexpr T kMin = std::numeric_limits<T>::min(), kMax = std::numeric_limits<T>::max();
  const T values[3][4] = {{kMin, kMax, kMax, 0}, {0, 0, 0, 0}, {kMax, kMax, 0, 0}};
  Bytes bytes(sizeof values);
  std::memcpy(bytes.data(), values, sizeof values);
  const std::string size = std::to_string(sizeof values), most = std::to_string(+kMax);
  return R"({"asset": {"version": "2.0"}, "extensionsUsed": ["KHR_mesh_quantization"],
    "extensionsRequired": ["KHR_mesh_quantization"],
    "buffers": [{"byteLength": )" +
         size + R"(, "uri": "data:;base64,)" + encodeBase64(bytes) + R"("}],
    "bufferViews": [{"buffer": 0, "byteLength": )" +
         size + R"(, "byteStride": )" + std::to_string(4 * sizeof(T)) + R"(}],
    "accessors": [{"bufferView": 0, "componentType": )" +
         std::to_string(componentType) + R"(, "count": 3, "type": "VEC3", "normalized": )" +
         (isNormalized ? "true" : "false") + R"(, "min": [)" + std::to_string(+kMin) +
         R"(, 0, 0], "max": [)" + most + ", " + most + ", " + most + R"(]}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}]})";
}

template <class T>
void expectQuantized(int componentType) {
  for (const bool isNormalized : {false, true}) {
    const DocumentPtr document = opened(quantizedText<T>(componentType, isNormalized));
    ASSERT_TRUE(document);
    const std::vector<Vec3>& positions = document->surfaces()[0].mesh.positions;
    ASSERT_EQ(positions.size(), 3U);
    // c / (2ⁿ − 1) without a sign; max(c / (2ⁿ⁻¹ − 1), −1) with one.
    const double least = std::numeric_limits<T>::min(), most = std::numeric_limits<T>::max();
    const double low = isNormalized ? (least < 0 ? -1.0 : 0.0) : least;
    const double high = isNormalized ? 1.0 : most;
    EXPECT_EQ(positions[0], (Vec3{low, high, high})) << componentType << isNormalized;
    EXPECT_EQ(positions[1], (Vec3{0.0, 0.0, 0.0})) << componentType << isNormalized;
    EXPECT_EQ(positions[2], (Vec3{high, high, 0.0})) << componentType << isNormalized;
  }
}

TEST(GltfDocument, QuantizedPositionsAreTheStandardsNumbers) {
  expectQuantized<std::int8_t>(5120);
  expectQuantized<std::uint8_t>(5121);
  expectQuantized<std::int16_t>(5122);
  expectQuantized<std::uint16_t>(5123);
}

TEST(GltfDocument, MapWithoutSeamsOnlyAddsText) {
  const std::string text = squareText();
  const DocumentPtr document = opened(text);
  ASSERT_TRUE(document);
  const MeshData& mesh = document->surfaces()[0].mesh;
  EXPECT_EQ(mesh.positions.size(), 4u);
  const std::string out = written(*document, vertexMap(mesh));
  expectOnlyInserted(text, out);
  EXPECT_NE(out.find("\"POSITION\" : 0, \"TEXCOORD_0\":2 }"), std::string::npos) << out;
  EXPECT_NE(out.find("[ 0.0, 0, 0e0 ]"), std::string::npos);
  const DocumentPtr again = opened(out);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->surfaces()[0].uvSets, std::vector<int>{0});
}

TEST(GltfDocument, PrimitivesOfAKindAreCountedInOneNote) {
  const auto primitives = [](std::initializer_list<int> modes) {
    std::string text;
    for (const int mode : modes)
      text += (text.empty() ? "" : ", ") +
              ("{ \"attributes\" : { \"POSITION\" : 0 }, \"indices\" : 1, \"mode\" : " +
               std::to_string(mode) + " }");
    return text;
  };
  const std::string one = "{ \"attributes\" : { \"POSITION\" : 0 }, \"indices\" : 1 }";
  const auto notes = [&](std::initializer_list<int> modes) {
    return opened(squareText({{one, primitives(modes)}}))->surfaces()[0].notes;
  };
  // Corners 0 1 2 0 2 3: of the four of a strip, one names a corner twice; of a fan, two do.
  EXPECT_EQ(phrase(notes({5})),
            "1 triangle strip is read as 3 triangles (1 degenerate one is skipped)");
  EXPECT_EQ(phrase(notes({6})),
            "1 triangle fan is read as 2 triangles (2 degenerate ones are skipped)");
  const Notes mixed = notes({4, 5, 6, 6, 1, 1, 0});
  EXPECT_EQ(test::codesOf(mixed),
            (test::Codes{"read-primitives-kept", "read-primitives-kept", "read-strips-unrolled"}));
  EXPECT_EQ(phrase(mixed),
            "1 primitive (points) is kept as it is; 2 primitives (lines) are kept as they are; 1 "
            "triangle strip and 2 triangle fans are read as 7 triangles (5 degenerate ones are "
            "skipped)");
}

TEST(GltfDocument, UvComeBackAsStoredWhereVerticesSplit) {
  const DocumentPtr document = opened(squareText());
  ASSERT_TRUE(document);
  const UvMap map = document->asStored(0, cornerMap(document->surfaces()[0].mesh));
  const auto result = document->write(0, map, {});
  ASSERT_TRUE(result);
  EXPECT_EQ(result->xref, (std::vector<int>{0, 1, 2, 3, 0, 2}));
  const DocumentPtr again = opened(textOf(result->files[0].bytes));
  ASSERT_TRUE(again);
  const auto uv = again->existingUv(0, 0);
  ASSERT_TRUE(uv);
  for (std::size_t t = 0; t < map.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(uv->uv[static_cast<std::size_t>(uv->cornerUv[t][k])],
                map.uv[static_cast<std::size_t>(map.cornerUv[t][k])]);
    }
  }
  EXPECT_EQ(again->surfaces()[0].mesh.positions, document->surfaces()[0].mesh.positions);
}

/// The square with these numbers as TEXCOORD_0.
DocumentPtr squareWithUv(const std::array<float, 8>& uv) {
  Bytes bytes(sizeof uv);
  std::memcpy(bytes.data(), uv.data(), sizeof uv);
  return opened(squareText(
      {{"} ],\n  \"bufferViews\"", "}, { \"byteLength\" : 32, \"uri\" : \"data:;base64," +
                                       encodeBase64(bytes) + "\" } ],\n  \"bufferViews\""},
       {"\"byteLength\" : 12 }", "\"byteLength\" : 12 }, { \"buffer\" : 1, \"byteLength\" : 32 }"},
       {"\"type\" : \"SCALAR\" }",
        "\"type\" : \"SCALAR\" }, { \"bufferView\" : 2, \"componentType\" : 5126, \"count\" : 4, "
        "\"type\" : \"VEC2\" }"},
       {"\"POSITION\" : 0", "\"POSITION\" : 0, \"TEXCOORD_0\" : 2"}}));
}

TEST(GltfDocument, UvForTheVerifierAreNotRounded) {
  // 1 − v is a double for ordinary v …
  const DocumentPtr plain = squareWithUv({0, 1, 1, 1, 1, 0.25f, 0, 0.25f});
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->exactUv(0, 0)->uv, plain->existingUv(0, 0)->uv);
  EXPECT_EQ(plain->exactUv(0, 0)->uv[2], (Vec2{1, 0.75}));
  // … and loses digits where v is tiny: there only v is exact.
  const DocumentPtr tiny = squareWithUv({0, 0, 1, 0, 1, -0x1.234568p-40f, 0, -0x1.234566p-40f});
  ASSERT_TRUE(tiny);
  EXPECT_EQ(tiny->exactUv(0, 0)->uv[2], (Vec2{1, 0x1.234568p-40}));
  EXPECT_EQ(tiny->exactUv(0, 0)->uv[3], (Vec2{0, 0x1.234566p-40}));
}

TEST(GltfDocument, ConesAreStoredInTheExtrasOfTheMesh) {
  WriteOptions options;
  options.cones = R"({"format":"hgp-cones","version":1,"q":6,"cones":[{"vertex":2,"k":5}]})";
  for (const char* extras :
       {"", ", \"extras\" : {\"mine\" : 1}", ", \"extras\" : {\"hgp\" : {\"old\" : 1}}"}) {
    const DocumentPtr document = opened(squareText(
        {{"\"indices\" : 1 } ] }", std::string("\"indices\" : 1 } ]") + extras + " }"}}));
    ASSERT_TRUE(document);
    const std::string out = written(*document, vertexMap(document->surfaces()[0].mesh), options);
    const DocumentPtr again = opened(out);
    ASSERT_TRUE(again);
    const auto cones = again->embeddedCones(0);
    ASSERT_TRUE(cones.hasValue() && cones->has_value()) << extras;
    EXPECT_EQ((*cones)->q, 6);
    EXPECT_EQ((*cones)->cones.at(0).vertex, 2);
  }
  options.cones = "not json";
  const DocumentPtr document = opened(squareText());
  const auto failed =
      document->write(0, document->asStored(0, vertexMap(document->surfaces()[0].mesh)), options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().code, ErrorCode::kWriteFailed);
}

TEST(GltfDocument, MapsThatFloat32CannotHoldAreRefused) {
  const DocumentPtr document = opened(squareText());
  ASSERT_TRUE(document);
  UvMap map = vertexMap(document->surfaces()[0].mesh);
  map.uv[0] = {0.1, 0.2};
  const auto result = document->write(0, map, {});
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::kWriteFailed);
  map.cornerUv.pop_back();
  EXPECT_FALSE(document->write(0, map, {}));
}

TEST(GltfDocument, CornersWithoutUvTakeAnyCopy) {
  const DocumentPtr document = opened(squareText());
  ASSERT_TRUE(document);
  UvMap map = document->asStored(0, vertexMap(document->surfaces()[0].mesh));
  map.cornerUv[1] = {-1, -1, -1};
  const auto result = document->write(0, map, {});
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->xref.empty());
}

TEST(GltfDocument, CompressedDataGoThroughTheDecodersGiven) {
  // The positions' view as if it were compressed; the "decoder" hands out the real numbers.
  const std::string text = squareText(
      {{"{ \"buffer\" : 0, \"byteLength\" : 48 }",
        "{ \"buffer\" : 0, \"byteLength\" : 48, \"byteStride\" : 12, \"extensions\" : { "
        "\"EXT_meshopt_compression\" : { \"buffer\" : 0, \"byteOffset\" : 4, \"byteLength\" : 8, "
        "\"byteStride\" : 12, \"count\" : 4, \"mode\" : \"ATTRIBUTES\" } } }"},
       {"\"asset\"", "\"extensionsUsed\" : [ \"EXT_meshopt_compression\" ], \"asset\""}});
  EXPECT_TRUE(gltfNeeds(bytesOf(text)).meshopt);
  EXPECT_FALSE(gltfNeeds(bytesOf(text)).draco);

  auto decoders = std::make_shared<GltfDecoders>();
  FileSet files = fileSet("packed.gltf", text);
  files.decoders = decoders;
  auto none = readGltf(files, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kUnsupported);

  decoders->meshopt = [](const MeshoptRequest& request) -> Result<Bytes> {
    EXPECT_EQ(request.source.size(), 8u);
    EXPECT_EQ(request.mode, "ATTRIBUTES");
    const float positions[] = {0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0};
    Bytes out(request.count * request.stride);
    std::memcpy(out.data(), positions, sizeof positions);
    return out;
  };
  const auto document = readGltf(files, {});
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ((*document)->surfaces()[0].mesh.positions[2], (Vec3{2, 2, 0}));

  decoders->meshopt = [](const MeshoptRequest&) -> Result<Bytes> { return Bytes(5); };
  const auto wrong = readGltf(files, {});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.error().code, ErrorCode::kMalformed);
}

TEST(GltfDocument, AdviceIsToRaiseTheLimitThatWasMet) {
  const auto adviceOf = [](const std::string& text, const Limits& limits) {
    const auto read = readGltf(fileSet("square.gltf", text), limits);
    EXPECT_FALSE(read);
    return read ? test::Codes{} : test::codesOf(read.error().advice);
  };
  const auto declaring = [](const std::string& length) {
    return squareText({{"\"byteLength\" : 60", "\"byteLength\" : " + length}});
  };
  EXPECT_EQ(adviceOf(declaring("50000"), {20'000, 10}), test::Codes{"raise-bytes"});
  EXPECT_EQ(adviceOf(squareText(), {20'000, 1}), test::Codes{"raise-triangles"});
  EXPECT_EQ(adviceOf(declaring("-1"), {20'000, 10}), test::Codes{}) << "it is malformed";
}

TEST(GltfDocument, SideFilesComeFromTheResolverAlone) {
  const std::string text = squareText();
  const std::size_t begin = text.find("data:"), end = text.find('"', begin);
  FileSet files = fileSet("a.gltf", text.substr(0, begin) + "part%20one.bin" + text.substr(end));
  std::vector<std::string> asked;
  const auto bytes = decodeBase64(text.substr(begin + 13, end - begin - 13));
  ASSERT_TRUE(bytes);
  files.resolve = [&](const std::string& name) -> Result<Bytes> {
    asked.push_back(name);
    return *bytes;
  };
  const auto document = readGltf(files, {});
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ(asked, std::vector<std::string>{"part one.bin"});
  WriteOptions options;
  options.name = "out.gltf";
  const UvMap map = (*document)->asStored(0, vertexMap((*document)->surfaces()[0].mesh));
  const auto result = (*document)->write(0, map, options);
  ASSERT_TRUE(result);
  ASSERT_EQ(result->files.size(), 2u);
  EXPECT_EQ(result->files[1].name, "out-uv.bin");
  EXPECT_EQ(result->files[1].bytes.size(), 4u * 8u);
}

TEST(GltfDocument, CaveIsReadCompletely) {
  std::string text;
  if (!readShared("gltf/cave.glb", text)) GTEST_SKIP() << sharedMeshes() << " is not there";
  FileSet files;
  files.name = "cave.glb";
  files.main = bytesOf(text);
  const auto document = readGltf(files, {});
  if (!builtInDecoders().draco) {
    ASSERT_FALSE(document);
    EXPECT_EQ(document.error().code, ErrorCode::kUnsupported);
    return;
  }
  ASSERT_TRUE(document) << document.error().message;
  EXPECT_EQ((*document)->surfaces()[0].mesh.triangles.size(), 595410u);
  EXPECT_EQ((*document)->surfaces()[0].mesh.positions.size(), 296677u);
}

/// The same map written into `text`, and again into the result.
std::pair<std::string, std::string> writtenTwice(const std::string& text,
                                                 const WriteOptions& options = {}) {
  const DocumentPtr first = opened(text);
  const std::string once = written(*first, cornerMap(first->surfaces()[0].mesh), options);
  const DocumentPtr second = opened(once);
  return {once, written(*second, cornerMap(second->surfaces()[0].mesh), options)};
}

TEST(GltfDocument, ItsOwnSetIsReplacedAndNothingGrows) {
  const auto [once, twice] = writtenTwice(squareText());
  EXPECT_EQ(once, twice);
  const DocumentPtr document = opened(once);
  EXPECT_EQ(document->surfaces()[0].ownUvSet, 0);
  // An extension that nobody knows cannot refer to it.
  const auto [strange, same] = writtenTwice(
      squareText({{"\"buffers\"", "\"extensionsUsed\" : [ \"X_other\" ], \"buffers\""}}));
  EXPECT_EQ(strange, same);
  // Also where other sets come before, and where lower sets were filled.
  WriteOptions third;
  third.uvSet = 2;
  const auto [later, again] = writtenTwice(once, third);
  EXPECT_EQ(later, again);
  EXPECT_EQ(opened(later)->surfaces()[0].uvSets, (std::vector<int>{0, 1, 2}));
}

TEST(GltfDocument, ASetOfAnotherProgramIsKeptAndTheNewOneIsFound) {
  const std::string text = squareText(
      {{"{ \"POSITION\" : 0 }", "{ \"POSITION\" : 0, \"TEXCOORD_0\" : 2 }"},
       {"\"type\" : \"SCALAR\" }",
        "\"type\" : \"SCALAR\" }, { \"bufferView\" : 0, \"componentType\" : 5126, \"count\" : 4, "
        "\"type\" : \"VEC2\" }"}});
  const auto [once, twice] = writtenTwice(text);
  EXPECT_EQ(once, twice);
  const DocumentPtr document = opened(once);
  EXPECT_EQ(document->surfaces()[0].uvSets, (std::vector<int>{0, 1}));
  EXPECT_EQ(document->surfaces()[0].ownUvSet, 1);
}

TEST(GltfDocument, WhereFourSetsAreTakenOneThatNoMaterialUsesIsReplaced) {
  const auto squareOf = [](const std::string& material, const std::string& use) {
    return squareText(
        {{"{ \"POSITION\" : 0 }",
          "{ \"POSITION\" : 0, \"TEXCOORD_0\" : 2, \"TEXCOORD_1\" : 2, \"TEXCOORD_2\" : 2, "
          "\"TEXCOORD_3\" : 2 }, " +
              use + "\"mode\" : 4"},
         {"\"type\" : \"SCALAR\" }",
          "\"type\" : \"SCALAR\" }, { \"bufferView\" : 0, \"componentType\" : 5126, \"count\" : 4, "
          "\"type\" : \"VEC2\" }"},
         {"\"meshes\"", material + "\"meshes\""}});
  };
  const auto setOf = [](const std::string& text, Notes& notes) {
    const DocumentPtr document = opened(text);
    const auto result =
        document->write(0, document->asStored(0, vertexMap(document->surfaces()[0].mesh)), {});
    EXPECT_TRUE(result);
    addNotes(notes, result->notes);
    return opened(textOf(result->files[0].bytes))->surfaces()[0].ownUvSet;
  };
  Notes notes;
  EXPECT_EQ(setOf(squareOf("", ""), notes), 3);
  ASSERT_TRUE(findNote(notes, "write-set-unread"));
  EXPECT_EQ(*findNote(notes, "write-set-unread")->find("set"), NoteValue("set", 3));
  const std::string picture =
      "\"images\" : [ { \"uri\" : \"data:image/png;base64,iVBORw0KGgo=\" } ], "
      "\"textures\" : [ { \"source\" : 0 } ], ";
  const std::string three = picture +
                            "\"materials\" : [ { \"emissiveTexture\" : { \"index\" : 0, "
                            "\"texCoord\" : 3 } } ], ";
  EXPECT_EQ(setOf(squareOf(three, "\"material\" : 0, "), notes), 2);
  const std::string all =
      picture +
      "\"materials\" : [ { \"emissiveTexture\" : { \"index\" : 0, \"texCoord\" : 3 }, "
      "\"normalTexture\" : { \"index\" : 0, \"texCoord\" : 2 }, \"occlusionTexture\" : { "
      "\"index\" : 0, \"texCoord\" : 1 } } ], ";
  notes.clear();
  EXPECT_EQ(setOf(squareOf(all, "\"material\" : 0, "), notes), 4);
  EXPECT_TRUE(findNote(notes, "write-set-high"));
}

}  // namespace
}  // namespace hgp::io
