#include <cstring>

#include "hgp/base/phrase.h"
#include "hgp/io/plain_surface.h"
#include "hgp/io/weld.h"
#include "io_support.h"
#include "support/notes.h"

namespace hgp::io {
namespace {

using test::openText;
using test::textOf;
using test::vertexMap;

const char kOff[] =
    "OFF # comment\n4 2 5\n0 0 0\n1 0 0 255 0 0\n1 1 0\n0 1 0\n4 0 1 2 3 0.5 0.5 0.5\n3 0 2 1\n";

void putFloat(std::string& out, float x, bool isBig = false) {
  char b[4];
  std::memcpy(b, &x, 4);
  for (int i = 0; i < 4; ++i) out += b[isBig ? 3 - i : i];
}
void putInt(std::string& out, std::int32_t x, bool isBig = false) {
  for (int i = 0; i < 4; ++i) out += static_cast<char>(x >> (8 * (isBig ? 3 - i : i)));
}

std::string binaryPly(bool isBig) {
  std::string out = std::string("ply\nformat binary_") + (isBig ? "big" : "little") +
                    "_endian 1.0\ncomment x\nelement vertex 4\nproperty float x\nproperty float y\n"
                    "property float z\nproperty uchar red\nelement face 2\n"
                    "property list uchar int vertex_indices\nend_header\n";
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.5f}};
  for (const auto& v : p) {
    for (float x : v) putFloat(out, x, isBig);
    out += '\x10';
  }
  out += '\3';
  for (int i : {0, 1, 2}) putInt(out, i, isBig);
  out += '\3';
  for (int i : {0, 2, 3}) putInt(out, i, isBig);
  return out;
}

const char kPly[] =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\nproperty "
    "double z\n"
    "property float s\nproperty float t\nelement face 1\nproperty list uchar int vertex_index\n"
    "end_header\n0 0 0 0.25 0.5\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n4 0 1 2 3\n";

std::string binaryStl() {
  std::string out(80, ' ');
  putInt(out, 2);
  const float t[2][9] = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {-0.0f, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (const auto& triangle : t) {
    for (int i = 0; i < 3; ++i) putFloat(out, 0);
    for (float x : triangle) putFloat(out, x);
    out += std::string(2, '\0');
  }
  return out;
}

const char kTextStl[] =
    "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 "
    "0\nendloop\nendfacet\n"
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 "
    "0\nendloop\nendfacet\nendsolid x\n";

TEST(Off, ReadsPolygonsCommentsAndColours) {
  Result<DocumentPtr> document = openText("a.off", kOff);
  ASSERT_TRUE(document.hasValue()) << document.error().message;
  EXPECT_STREQ((*document)->format(), "off");
  EXPECT_EQ((*document)->surfaces()[0].mesh.positions.size(), 4u);
  EXPECT_EQ((*document)->surfaces()[0].mesh.triangles.size(), 3u);
}

TEST(Off, IsRecognisedByContent) { EXPECT_TRUE(openText("noname", kOff).hasValue()); }

TEST(Ply, ReadsTextAndBothByteOrders) {
  Result<DocumentPtr> little = openText("a.ply", binaryPly(false));
  Result<DocumentPtr> big = openText("a.ply", binaryPly(true));
  ASSERT_TRUE(little.hasValue()) << little.error().message;
  ASSERT_TRUE(big.hasValue()) << big.error().message;
  EXPECT_EQ((*little)->surfaces()[0].mesh.positions, (*big)->surfaces()[0].mesh.positions);
  EXPECT_EQ((*little)->surfaces()[0].mesh.triangles, (*big)->surfaces()[0].mesh.triangles);
  EXPECT_EQ((*big)->surfaces()[0].mesh.positions[3], (Vec3{0, 1, 0.5}));
  Result<DocumentPtr> text = openText("a.ply", kPly);
  ASSERT_TRUE(text.hasValue()) << text.error().message;
  const std::optional<UvMap> uv = (*text)->existingUv(0, 0);
  ASSERT_TRUE(uv.has_value());
  const std::array<int, 3> corners = (*text)->surfaces()[0].mesh.triangles[0];
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k] != 0) continue;
    EXPECT_EQ(uv->uv[static_cast<std::size_t>(uv->cornerUv[0][k])], (Vec2{0.25, 0.5}));
  }
}

TEST(Stl, WeldsEqualPositionsIncludingMinusZero) {
  for (const std::string& text : {binaryStl(), std::string(kTextStl)}) {
    Result<DocumentPtr> document = openText("a.stl", text);
    ASSERT_TRUE(document.hasValue()) << document.error().message;
    const Surface& s = (*document)->surfaces()[0];
    EXPECT_EQ(s.mesh.positions.size(), 4u);
    EXPECT_EQ(s.storedVertexCount, 6);
    EXPECT_TRUE(s.isWelded);
    EXPECT_EQ(s.mesh.triangles[1], (std::array<int, 3>{0, 2, 3}));
  }
}

TEST(PlainObj, IsWhatOtherFormatsAreWrittenAs) {
  Result<DocumentPtr> document = openText("a.off", kOff);
  ASSERT_TRUE(document.hasValue());
  const UvMap map = vertexMap((*document)->surfaces()[0].mesh);
  Result<Written> out = (*document)->write(0, (*document)->asStored(0, map), {});
  ASSERT_TRUE(out.hasValue());
  const std::string text = textOf(out->files[0].bytes);
  Result<DocumentPtr> again = openText("a.obj", text);
  ASSERT_TRUE(again.hasValue()) << text;
  EXPECT_EQ((*again)->surfaces()[0].mesh.positions, (*document)->surfaces()[0].mesh.positions);
  EXPECT_EQ((*again)->surfaces()[0].mesh.triangles, (*document)->surfaces()[0].mesh.triangles);
  EXPECT_NE(text.find("f 1/1 2/2 3/3 4/4\n"), std::string::npos) << "polygons stay whole";
}

TEST(Weld, NearJoinsAcrossCellBorders) {
  const std::vector<Vec3> p = {
      {0.999, 0, 0}, {1.001, 0, 0}, {2, 0, 0}, {-1e-4, 0, 0}, {1e-4, 0, 0}};
  const Weld weld = weldNear(p, 0.01);
  EXPECT_EQ(weld.welded, (std::vector<int>{0, 0, 1, 2, 2}));
  EXPECT_EQ(weld.firstStored, (std::vector<int>{0, 2, 3}));
}

TEST(Weld, NearKeepsApartWhatIsFartherThanTheTolerance) {
  // In neighbouring cells, and in the same one.
  const std::vector<Vec3> p = {
      {0.012, 0, 0}, {0.027, 0, 0}, {0.5, 0.501, 0.501}, {0.5, 0.509, 0.509}};
  EXPECT_EQ(weldNear(p, 0.01).welded, (std::vector<int>{0, 1, 2, 3}));
}

TEST(HostileFormats, EndInAFailureAndNothingElse) {
  const std::string ply = binaryPly(false), stl = binaryStl();
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"},
      {"a.off", "OFF\n999999999 999999999 0\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 nan\n3 0 1 2\n"},
      {"a.off", "OFF BINARY\n\1\2\3"},
      {"a.off", "OFF\n-3 1 0\n"},
      {"a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n"},
      {"a.off", "OFF\n"},
      {"a.ply", "ply\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 99999999999999\nproperty float x\nend_header\n"},
      {"a.ply", "ply\nformat ascii 1.0\nelement vertex -1\nend_header\n"},
      {"a.ply", "ply\nformat binary_little_endian 1.0\nproperty float x\nend_header\n"},
      {"a.ply", ply.substr(0, ply.size() - 3)},
      {"a.ply", ply.substr(0, ply.size() - 4) + std::string(4, '\x7f')},
      {"a.ply", std::string(kPly).substr(0, std::string(kPly).size() - 4)},
      {"a.stl", stl.substr(0, stl.size() - 1)},
      {"a.stl", "solid x\nfacet\nouter loop\nvertex 0 0 0\nendloop\n"},
      {"a.stl", "solid x\nendsolid x\n"},
      {"a.stl", std::string(84, '\xff')},
      {"a.stl", "nonsense"},
  };
  for (const auto& [name, text] : files) {
    Result<DocumentPtr> document = openText(name, text);
    ASSERT_FALSE(document.hasValue()) << name << ": " << text.substr(0, 60);
    EXPECT_TRUE(document.error().code == ErrorCode::kMalformed ||
                document.error().code == ErrorCode::kLimit);
    EXPECT_FALSE(document.error().message.empty());
  }
}

TEST(HostileFormats, EveryPrefixAndEveryFlippedByteIsSurvived) {
  for (const std::string& good : {std::string(kOff), binaryPly(false), std::string(kPly),
                                  binaryStl(), std::string(kTextStl)}) {
    const std::string name = good.substr(0, 3) == "ply" ? "a.ply"
                             : good[0] == 'O'           ? "a.off"
                                                        : "a.stl";
    for (std::size_t n = 0; n < good.size(); ++n) {
      (void)openText(name, good.substr(0, n));
      std::string bad = good;
      bad[n] = static_cast<char>(bad[n] ^ 0x81);
      (void)openText(name, bad);
      bad[n] = '9';
      (void)openText(name, bad);
    }
  }
}

TEST(SharedMeshes, AreReadWithTheirCounts) {
  struct Known {
    const char* name;
    std::size_t vertices, triangles;
  };
  const Known known[] = {{"ConformalIdealDelaunay/aircraft.obj", 2349, 4656},
                         {"Directional/eight.off", 5544, 11092},
                         {"geometry-central/bob_small.ply", 250, 500},
                         {"geometry-central/lego.ply", 1649, 3072},
                         {"geometry-central/moebius.obj", 280, 448},
                         {"OptCuts/multiComp.obj", 4081, 7942}};
  for (const Known& k : known) {
    std::string text;
    if (!test::readShared(k.name, text))
      GTEST_SKIP() << "no data folder at " << test::sharedMeshes();
    Result<DocumentPtr> document = openText(k.name, text);
    ASSERT_TRUE(document.hasValue()) << k.name << ": " << document.error().message;
    const Surface& s = (*document)->surfaces()[0];
    EXPECT_EQ(s.mesh.positions.size(), k.vertices) << k.name;
    if (std::string(k.name).find("bob") == std::string::npos &&
        std::string(k.name).find("moebius") == std::string::npos) {
      EXPECT_EQ(s.mesh.triangles.size(), k.triangles) << k.name;
    }
    const UvMap stored = (*document)->asStored(0, vertexMap(s.mesh));
    Result<Written> out = (*document)->write(0, stored, {});
    ASSERT_TRUE(out.hasValue());
    Result<DocumentPtr> again = openText("x.obj", textOf(out->files[0].bytes));
    ASSERT_TRUE(again.hasValue());
    const std::optional<UvMap> back = (*again)->existingUv(0, 0);
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(back->uv, stored.uv);
    EXPECT_EQ(back->cornerUv, stored.cornerUv);
    EXPECT_EQ((*again)->surfaces()[0].mesh.triangles, s.mesh.triangles);
  }
}

using test::fileSet;
using test::written;

const char* kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n";

DocumentPtr openedPly(const std::string& text, const std::string& target) {
  FileSet files = fileSet("mesh.ply", text);
  files.target = target;
  auto document = openDocument(std::move(files), Limits());
  EXPECT_TRUE(document.hasValue()) << (document ? "" : document.error().message);
  return document ? std::move(*document) : nullptr;
}

auto asWritten(const Document& document) {
  return document.write(0, document.asStored(0, vertexMap(document.surfaces()[0].mesh)), {});
}

TEST(Ply, LinesOfTheHeaderWithOtherKeywordsAreSkippedAndKept) {
  const std::string body = "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2\n3 0 2 3\n";
  const std::string line = "Created by a program of 2006\n";
  std::string text = kPlyHeader;
  text.insert(text.find("element"), line);
  const DocumentPtr document = openedPly(text + body, "ply");
  ASSERT_TRUE(document);
  const Notes& notes = document->surfaces()[0].notes;
  ASSERT_TRUE(findNote(notes, "read-unknown-lines"));
  EXPECT_EQ(*findNote(notes, "read-unknown-lines")->find("lines"), NoteValue("lines", 1));
  const UvMap map = vertexMap(document->surfaces()[0].mesh);
  WriteOptions options;
  options.format = "ply";
  options.generator = "hgp test";
  const std::string out = written(*document, map, options);
  EXPECT_NE(out.find(line), std::string::npos) << out;
  // A property that is mistyped would shift all that follow.
  for (const char* wrong : {"proprety float w\n", "Property float w\n", "elment edge 1\n"}) {
    std::string other = kPlyHeader;
    other.insert(other.find("element face"), wrong);
    EXPECT_FALSE(openText("a.ply", other + body)) << wrong;
  }
}

TEST(Ply, UvAreFloatsAndWritingAgainChangesNothing) {
  const std::string text =
      std::string(kPlyHeader) + "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2\n3 0 2 3\n";
  const DocumentPtr document = openedPly(text, "ply");
  EXPECT_EQ(document->uvPrecision(), UvPrecision::kFloat32);
  const UvMap map = vertexMap(document->surfaces()[0].mesh);
  WriteOptions options;
  options.format = "ply";
  options.generator = "hgp test";
  const std::string out = written(*document, map, options);
  EXPECT_NE(out.find("property list uchar float texcoord"), std::string::npos) << out;
  const DocumentPtr again = openedPly(out, "ply");
  EXPECT_EQ(again->uvPrecision(), UvPrecision::kFloat32);
  EXPECT_EQ(written(*again, map, options), out);
  // Verified as floats; written as OBJ, solved in doubles.
  EXPECT_EQ(openedPly(out, "")->uvPrecision(), UvPrecision::kFloat32);
  EXPECT_EQ(openedPly(out, "obj")->uvPrecision(), UvPrecision::kFloat64);
  EXPECT_EQ(openedPly(text, "")->uvPrecision(), UvPrecision::kFloat64);
  const auto uv = openedPly(out, "")->existingUv(0, 0);
  ASSERT_TRUE(uv);
  for (const Vec2& p : uv->uv)
    for (const double x : p) EXPECT_EQ(x, static_cast<double>(static_cast<float>(x)));
}

TEST(Ply, ListsOfDoublesStayDoubles) {
  std::string text = std::string(kPlyHeader) +
                     "0 0 0\n1 0 0\n1 1 0\n0 1 0.5\n3 0 1 2 6 0 0 1 0 1 1\n"
                     "3 0 2 3 6 0 0 1 1 0 1\n";
  text.insert(text.find("end_header"), "property list uchar double texcoord\n");
  const DocumentPtr document = openedPly(text, "ply");
  EXPECT_EQ(document->uvPrecision(), UvPrecision::kFloat64);
  WriteOptions options;
  options.format = "ply";
  EXPECT_NE(written(*document, vertexMap(document->surfaces()[0].mesh), options)
                .find("property list uchar double texcoord"),
            std::string::npos);
}

TEST(Ply, LinesWithMoreValuesThanTheHeaderAreCut) {
  const std::string text = std::string(kPlyHeader) +
                           "0 0 0 7 8 9\n1 0 0 7 8 9\ncomment 1 2\n1 1 0 7 8 9\r\n\n0 1 0.5 7 8 9\n"
                           "3 0 1 2 255\n3 0 2 3\n";
  const DocumentPtr document = openedPly(text, "ply");
  ASSERT_TRUE(document);
  const Surface& surface = document->surfaces()[0];
  EXPECT_EQ(surface.mesh.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(surface.mesh.positions[3], (Vec3{0, 1, 0.5}));
  ASSERT_FALSE(surface.notes.empty());
  EXPECT_EQ(surface.notes[0], Note("read-extra-values", {{"lines", 5}}));
  WriteOptions options;
  options.format = "ply";
  const DocumentPtr again = openedPly(written(*document, vertexMap(surface.mesh), options), "ply");
  EXPECT_TRUE(again->surfaces()[0].notes.empty());
  EXPECT_EQ(again->surfaces()[0].mesh.positions, surface.mesh.positions);
  // Several rows on a line are read value by value, as before.
  const std::string dense =
      std::string(kPlyHeader) + "0 0 0 1 0 0\n1 1 0 0 1 0.5\n3 0 1 2 3 0 2 3\n";
  EXPECT_EQ(openedPly(dense, "")->surfaces()[0].mesh.triangles, surface.mesh.triangles);
}

TEST(Ply, NormalsAndColoursGoIntoAnObj) {
  std::string text = std::string(kPlyHeader) +
                     "0 0 0 0 0 1 255 0 51\n1 0 0 0 0 1 0 255 0\n1 1 0 0 0 1 0 0 255\n"
                     "0 1 0 0 1 0 1 2 3\n3 0 1 2\n3 0 2 3\n";
  text.insert(text.find("element face"),
              "property float nx\nproperty float ny\nproperty float nz\nproperty uchar red\n"
              "property uchar green\nproperty uchar blue\n");
  const DocumentPtr document = openedPly(text, "obj");
  ASSERT_TRUE(document);
  const auto out = asWritten(*document);
  ASSERT_TRUE(out);
  const std::string obj = textOf(out->files[0].bytes);
  EXPECT_NE(obj.find("v 0 0 0 1 0 0.2\n"), std::string::npos) << obj;
  EXPECT_NE(obj.find("vn 0 1 0\n"), std::string::npos);
  EXPECT_NE(obj.find("f 1/1/1 2/2/2 3/3/3\n"), std::string::npos);
  ASSERT_EQ(test::codesOf(out->notes), test::Codes{"write-as-obj"});
  EXPECT_EQ(phrase(out->notes[0]), "written as OBJ, with its normals and colours");
}

TEST(Ply, TheOrderOfThePropertiesIsFree) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty uchar red\nproperty float nx\n"
      "property float x\nproperty float y\nproperty float z\nproperty float nz\n"
      "property float ny\nproperty uchar blue\nproperty uchar green\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "255 1 0 0 0 0 0 51 0\n0 0 1 0 0 1 0 0 255\n0 0 0 1 0 0 1 255 0\n3 0 1 2\n";
  const DocumentPtr document = openedPly(text, "obj");
  ASSERT_TRUE(document);
  const auto out = asWritten(*document);
  ASSERT_TRUE(out);
  const std::string obj = textOf(out->files[0].bytes);
  for (const char* line : {"v 0 0 0 1 0 0.2\n", "v 1 0 0 0 1 0\n", "v 0 1 0 0 0 1\n", "vn 1 0 0\n",
                           "vn 0 0 1\n", "vn 0 1 0\n"})
    EXPECT_NE(obj.find(line), std::string::npos) << line << "in\n" << obj;
}

TEST(Obj, WhatAnotherFormatCannotKeepIsSaid) {
  const auto document =
      openText("a.obj", "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 0 0 1\nf 1 2 3\nl 1 2\np 3\n");
  ASSERT_TRUE(document);
  const Result<PlainFile> plain = (*document)->plain(0);
  ASSERT_TRUE(plain);
  ASSERT_EQ(plain->surfaces[0].colors.size(), 3U);
  EXPECT_EQ(plain->surfaces[0].colors[1], (std::array<double, 4>{1, 1, 1, 1}));
  EXPECT_EQ(plain->surfaces[0].colors[2], (std::array<double, 4>{0, 0, 1, 1}));
  EXPECT_EQ(plain->lost, (Notes{Note("convert-uncoloured", {{"vertices", 1}}),
                                Note("convert-lines-lost", {{"lines", 2}})}));
  const auto none = openText("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  ASSERT_TRUE(none);
  EXPECT_TRUE((*none)->plain(0)->surfaces[0].colors.empty());
  EXPECT_TRUE((*none)->plain(0)->lost.empty());
}

}  // namespace
}  // namespace hgp::io
