// Files that good readers take although the letter of the format forbids them: each is read, says so
// in a note, and is written back with everything that was not understood left as it was.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <tuple>

#include "io_support.h"

namespace hgp::io {
namespace {

using test::openText;
using test::vertexMap;
using test::written;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kFaces = "f 1 2 3\nf 1 3 4\n";

struct Lenient {
  const char* name;
  std::string file;
  std::string text;
  const char* note;  ///< its code; "" for none
};

class LenientFiles : public ::testing::TestWithParam<Lenient> {};

TEST_P(LenientFiles, AreReadAsTheSquareTheyAreWithANote) {
  const Lenient& given = GetParam();
  Result<DocumentPtr> document = openText(given.file, given.text);
  ASSERT_TRUE(document.hasValue()) << document.error().message;
  const Surface& surface = (*document)->surfaces()[0];
  ASSERT_EQ(surface.mesh.triangles.size(), 2u);
  // The same two triangles, whatever the numbering: counterclockwise from above, area ½ each.
  for (const auto& t : surface.mesh.triangles) {
    const auto at = [&](std::size_t k) {
      return surface.mesh.positions[static_cast<std::size_t>(t[k])];
    };
    const Vec3 a = at(0), b = at(1), c = at(2);
    EXPECT_EQ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]), 1.0);
  }
  const std::string expected = given.note;
  const bool isSaid = std::any_of(surface.notes.begin(), surface.notes.end(),
                                  [&](const Note& note) { return note.code == expected; });
  EXPECT_TRUE(expected.empty() || isSaid) << given.name;
}

std::string withCarriageReturns(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '\r');
  return text;
}

std::string little(std::uint32_t x) {
  std::string out;
  for (int i = 0; i < 4; ++i) out += static_cast<char>(x >> (8 * i));
  return out;
}

std::string binaryStl(std::uint32_t count, const std::string& tail, char fill = ' ') {
  std::string out = std::string(80, fill) + little(count);
  const float corners[2][9] = {{0, 0, 0, 1, 0, 0, 1, 1, 0}, {0, 0, 0, 1, 1, 0, 0, 1, 0}};
  for (const auto& t : corners) {
    out += std::string(12, '\0');
    for (float x : t) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &x, 4);
      out += little(bits);
    }
    out += std::string(2, '\0');
  }
  return out + tail;
}

const std::string kMark = "\xEF\xBB\xBF";
const std::string kOffBody = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string kOffFaces = "3 0 1 2\n3 0 2 3\n";
const std::string kPlyVertices =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\n";
const std::string kPlyFaces =
    "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
const std::string kStl =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\n"
    "endfacet\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid a\n";

std::string capitals(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    Table, LenientFiles,
    ::testing::Values(
        Lenient{"objOneCorner", "a.obj", kSquare + "f 1\n" + kFaces, "read-small-lines-skipped"},
        Lenient{"objTwoCorners", "a.obj", kSquare + kFaces + "f 1 2\nf\n",
                "read-small-lines-skipped"},
        Lenient{"objVtBeyond", "a.obj", kSquare + "vt 0 0\nf 1/1 2/9 3/-7\nf 1 3 4\n",
                "read-uv-missing"},
        Lenient{"objCommentBackslash", "a.obj", "# C:\\\n" + kSquare + kFaces, ""},
        Lenient{"objInlineCommentBackslash", "a.obj", kSquare + "f 1 2 3 # D:\\\nf 1 3 4\n", ""},
        Lenient{"objCarriageReturns", "a.obj", withCarriageReturns(kSquare + "# c\n" + kFaces),
                "read-line-ends"},
        Lenient{"objLongName", "a.obj",
                kSquare + "o " + std::string(std::size_t{1} << 21, 'n') + "\n" + kFaces, ""},
        Lenient{"offMark", "a.off", kMark + "OFF\n4 2 0\n" + kOffBody + kOffFaces, ""},
        Lenient{"offNoEdges", "a.off", "OFF\n4 2\n" + kOffBody + kOffFaces, ""},
        Lenient{"offCountsOnLines", "a.off", "OFF\n4\n2\n5\n" + kOffBody + kOffFaces, ""},
        Lenient{"offNoKeyword", "a.off", "4 2 0\n" + kOffBody + kOffFaces, "read-keyword-missing"},
        Lenient{"offBlankLines", "a.off", "\n\n  OFF\n\n4 2 0\n\n" + kOffBody + kOffFaces, ""},
        Lenient{"offThreeColours", "a.off",
                "COFF\n4 2 0\n0 0 0 1 0 0\n1 0 0 1 0 0\n1 1 0 1 0 0\n0 1 0 1 0 0\n"
                "3 0 1 2 0.0 0.5 0.5\n3 0 2 3 0.0 0.5 0.5\n",
                ""},
        Lenient{"offUvAndColours", "a.off",
                "STCOFF\n4 2 0\n0 0 0 9 9 9 0 0\n1 0 0 9 9 9 1 0\n1 1 0 9 9 9 1 1\n"
                "0 1 0 9 9 9 0 1\n" +
                    kOffFaces,
                ""},
        Lenient{"offHomogeneous", "a.off",
                "4OFF\n4 2 0\n0 0 0 2\n2 0 0 2\n2 2 0 2\n0 2 0 2\n" + kOffFaces, ""},
        Lenient{"offTwoCorners", "a.off", "OFF\n4 3 0\n" + kOffBody + "2 0 1\n" + kOffFaces,
                "read-small-faces-skipped"},
        Lenient{"offCarriageReturns", "a.off",
                withCarriageReturns("OFF # c\n4 2 0\n" + kOffBody + kOffFaces), ""},
        Lenient{"plyMark", "a.ply", kMark + kPlyVertices + kPlyFaces + kOffBody + kOffFaces, ""},
        Lenient{"plyCarriageReturns", "a.ply",
                withCarriageReturns(kPlyVertices + kPlyFaces + kOffBody + kOffFaces), ""},
        Lenient{"plyComments", "a.ply",
                kPlyVertices + kPlyFaces + kOffBody + "comment here 1 2 3\n" + kOffFaces, ""},
        Lenient{"plyTwoCorners", "a.ply",
                kPlyVertices +
                    "element face 3\nproperty list uchar int vertex_index\nend_header\n" +
                    kOffBody + "2 0 1\n" + kOffFaces,
                "read-small-faces-skipped"},
        Lenient{"plyStrip", "a.ply",
                kPlyVertices + "element tristrips 1\nproperty list int int vertex_indices\n" +
                    "end_header\n" + kOffBody + "4 1 2 0 3\n",
                "read-strips"},
        Lenient{"plyTwoStrips", "a.ply",
                kPlyVertices + "element tristrips 1\nproperty list int int vertex_indices\n" +
                    "end_header\n" + kOffBody + "7 0 1 2 -1 0 2 3\n",
                "read-strips"},
        Lenient{"stlCapitals", "a.stl", capitals(kStl), ""},
        Lenient{"stlComments", "a.stl", "# made by hand\n\n" + kStl, ""},
        Lenient{"stlMark", "a.stl", kMark + kStl, ""},
        Lenient{"stlCarriageReturns", "a.stl", withCarriageReturns(kStl), ""},
        Lenient{"stlTail", "a.stl", binaryStl(2, "tail"), "read-stl-longer"},
        Lenient{"stlNoCount", "a.stl", binaryStl(0, ""), "read-stl-count"},
        Lenient{"stlSolidTail", "a.stl", "solid" + binaryStl(2, "x").substr(5), "read-stl-longer"}),
    [](const ::testing::TestParamInfo<Lenient>& file) { return std::string(file.param.name); });

TEST(LenientObj, SkippedFacesStayInTheFileWithoutTheirOldVt) {
  const std::string text = kSquare + "vt 0 0\nf 1/1 2/1\nf 1/1 2/1 3/1 # D:\\\nf 1 3 4\n";
  Result<DocumentPtr> document = openText("a.obj", text);
  ASSERT_TRUE(document.hasValue());
  const std::string out = written(**document, vertexMap((*document)->surfaces()[0].mesh));
  EXPECT_NE(out.find("\nf 1 2\n"), std::string::npos) << out;
  EXPECT_NE(out.find(" # D:\\\n"), std::string::npos) << out;
  Result<DocumentPtr> again = openText("a.obj", out);
  ASSERT_TRUE(again.hasValue()) << again.error().message;
  EXPECT_EQ((*again)->surfaces()[0].uvSets.size(), 1u);
}

TEST(LenientObj, CarriageReturnsStayTheOnlyLineEnds) {
  Result<DocumentPtr> document = openText("a.obj", withCarriageReturns(kSquare + kFaces));
  ASSERT_TRUE(document.hasValue());
  const UvMap map = vertexMap((*document)->surfaces()[0].mesh);
  const std::string out = written(**document, map);
  EXPECT_EQ(out.find('\n'), std::string::npos);
  Result<DocumentPtr> again = openText("a.obj", out);
  ASSERT_TRUE(again.hasValue()) << again.error().message;
  const auto back = (*again)->existingUv(0, 0);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(back->uv[2], map.uv[2]);
}

const std::string kJunk[] = {"nan -NaN 0", "0 -nan(ind) inf", "-1.#IND 1.#QNAN0 2",
                             "0 1e999 -Infinity"};

std::string junkLines(const std::string& before) {
  std::string out;
  for (const std::string& junk : kJunk) out += before + junk + "\n";
  return out;
}

TEST(LenientVertices, PositionsThatAreNotFiniteStayWhereNoFaceUsesThem) {
  const std::string faces = "3 4 5 6\n3 4 6 7\n";
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\n"
      "property float z\nproperty float quality\n" +
      kPlyFaces;
  std::string rows = junkLines("") + kOffBody;
  std::string withQuality;
  for (const char c : rows) withQuality += c == '\n' ? std::string(" nan\n") : std::string(1, c);
  const std::pair<const char*, std::string> files[] = {
      {"a.obj", junkLines("v ") + kSquare + "vt nan 0\nf 5/1 6/1 7/1\nf 5/1 7/1 8/1\n"},
      {"a.off", "OFF\n8 2 0\n" + junkLines("") + kOffBody + faces},
      {"a.ply", ply + withQuality + faces},
  };
  for (const auto& [name, text] : files) {
    Result<DocumentPtr> document = openText(name, text);
    ASSERT_TRUE(document.hasValue()) << name << ": " << document.error().message;
    const Surface& surface = (*document)->surfaces()[0];
    EXPECT_EQ(surface.mesh.positions[4], (Vec3{0, 0, 0})) << name;
    EXPECT_EQ(surface.mesh.positions[6], (Vec3{1, 1, 0})) << name;
    for (std::size_t v = 0; v < 4; ++v) {
      const Vec3& p = surface.mesh.positions[v];
      EXPECT_FALSE(std::isfinite(p[0] + p[1] + p[2])) << name << ", vertex " << v;
    }
    WriteOptions options;
    if (std::string(name) == "a.ply") options.format = "ply";
    const std::string out = written(**document, vertexMap(surface.mesh), options);
    EXPECT_TRUE(openText(name[2] == 'o' ? "b.obj" : name, out).hasValue()) << out;
    for (const std::string& junk : kJunk) {
      const bool isKept = out.find(junk) != std::string::npos;
      EXPECT_TRUE(isKept || std::string(name) == "a.off") << name << ": " << junk;
    }
  }
}

TEST(LenientVertices, UsedByAFaceTheyAreRefusedByNameAndLine) {
  const std::string head = kPlyVertices.substr(0, kPlyVertices.find('4')) + "5" +
                           kPlyVertices.substr(kPlyVertices.find('4') + 1);
  const std::tuple<const char*, std::string, const char*> files[] = {
      {"a.obj", "v inf 0 0\n" + kSquare + "v 0 0 -1.#IND\nf 2 3 6\n", "line 6: vertex 5 "},
      {"a.off", "OFF\n5 2 0\n" + kOffBody + "0 0 nan\n3 0 1 2\n3 0 2 4\n", "line 7: vertex 4 "},
      {"a.ply", head + kPlyFaces + kOffBody + "0 1e400 0\n3 0 1 2\n3 0 2 4\n",
       "line 14: vertex 4 "},
  };
  for (const auto& [name, text, words] : files) {
    Result<DocumentPtr> document = openText(name, text);
    ASSERT_FALSE(document.hasValue()) << name;
    EXPECT_EQ(document.error().code, ErrorCode::kMalformed);
    EXPECT_EQ(document.error().message.find(words), 0u) << document.error().message;
  }
}

TEST(LenientStl, AnnouncedButMissingTrianglesAreStillRefused) {
  EXPECT_FALSE(openText("a.stl", binaryStl(3, "")).hasValue());
  EXPECT_FALSE(openText("a.stl", binaryStl(0, "xx")).hasValue());
}

}  // namespace
}  // namespace hgp::io
