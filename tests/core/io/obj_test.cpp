#include <algorithm>
#include <ctime>
#include <sstream>

#include "hgp/text/text.h"
#include "io_support.h"

namespace hgp::io {
namespace {

using test::cornerMap;
using test::openText;
using test::textOf;
using test::vertexMap;

const char kMixed[] =
    "# a comment\r\n"
    "mtllib things.mtl\r\n"
    "o first\r\n"
    "v 0 0 0\r\nv 1 0 0 0.5 0.5 0.5\r\nv 1 1 0\r\nv 0 1 0\r\n"
    "vt 0 0\r\nvt 1 0\r\n"
    "vn 0 0 1\r\n"
    "usemtl red\r\n"
    "s off\r\n"
    "f 1/1/1 2/2/1 3/1/1 4/2/1   # a quad\r\n"
    "v 0 0 1\n"
    "g second\n"
    "f -1 -5//1 \\\n  -4//1\n"
    "l 1/1 2/2 3\n"
    "weird stuff 1 2 3\n"
    "f 1// 5 4";

void expectSameMap(const UvMap& a, const UvMap& b) {
  ASSERT_EQ(a.cornerUv.size(), b.cornerUv.size());
  for (std::size_t t = 0; t < a.cornerUv.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(a.uv[static_cast<std::size_t>(a.cornerUv[t][k])],
                b.uv[static_cast<std::size_t>(b.cornerUv[t][k])]);
    }
  }
}

TEST(Obj, ReadsPolygonsRelativeIndicesAndContinuations) {
  Result<DocumentPtr> document = openText("a.obj", kMixed);
  ASSERT_TRUE(document.hasValue()) << document.error().message;
  const MeshData& mesh = (*document)->surfaces()[0].mesh;
  EXPECT_EQ(mesh.positions.size(), 5u);
  ASSERT_EQ(mesh.triangles.size(), 4u);
  EXPECT_EQ(mesh.triangles[2], (std::array<int, 3>{4, 0, 1}));
  EXPECT_EQ(mesh.triangles[3], (std::array<int, 3>{0, 4, 3}));
  EXPECT_FALSE((*document)->existingUv(0, 0).has_value()) << "some corners have no vt";
}

TEST(Obj, RelativeTextureIndicesCountBackFromTheFace) {
  const char text[] =
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 0.5 0\nvt 0 0.25\nf -3/-3 -2/-2 -1/-1\n"
      "v 5 5 5\nvt 0.75 0.75\nf -2/-2 -3/-3 -1/-1\n";
  Result<DocumentPtr> document = openText("a.obj", text);
  ASSERT_TRUE(document.hasValue()) << document.error().message;
  const std::optional<UvMap> map = (*document)->existingUv(0, 0);
  ASSERT_TRUE(map);
  const Vec2 expected[2][3] = {{{0, 0}, {0.5, 0}, {0, 0.25}}, {{0, 0.25}, {0.5, 0}, {0.75, 0.75}}};
  for (std::size_t f = 0; f < 2; ++f)
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_EQ(map->uv[static_cast<std::size_t>(map->cornerUv[f][k])], expected[f][k]) << f << k;
}

TEST(Obj, WritingTouchesNothingButFacesAndTextureCoordinates) {
  Result<DocumentPtr> document = openText("a.obj", kMixed);
  ASSERT_TRUE(document.hasValue());
  const UvMap map = vertexMap((*document)->surfaces()[0].mesh);
  const std::string text = test::written(**document, map);
  const auto keptLines = [](const std::string& source) {
    std::vector<std::string> lines;
    std::istringstream in(source);
    for (std::string line; std::getline(in, line);) {
      const bool isOurs = line[0] == 'f' || line.compare(0, 2, "vt") == 0 || line[0] == 'l' ||
                          line.compare(0, 2, "  ") == 0;
      if (!isOurs) lines.push_back(line);
    }
    return lines;
  };
  EXPECT_EQ(keptLines(text), keptLines(kMixed));
  EXPECT_NE(text.find("   # a quad\r\n"), std::string::npos);
  EXPECT_NE(text.find("/1 \\\n  -4/"), std::string::npos) << "normals and relative spelling stay";
  EXPECT_NE(text.find("l 1 2 3\n"), std::string::npos) << text;
}

TEST(Obj, ReadOfWriteIsTheSameMapBitForBit) {
  Result<DocumentPtr> document = openText("a.obj", kMixed);
  ASSERT_TRUE(document.hasValue());
  const UvMap stored = (*document)->asStored(0, vertexMap((*document)->surfaces()[0].mesh));
  const std::string text = test::written(**document, stored);
  Result<DocumentPtr> again = openText("b.obj", text);
  ASSERT_TRUE(again.hasValue()) << again.error().message;
  const std::optional<UvMap> back = (*again)->existingUv(0, 0);
  ASSERT_TRUE(back.has_value());
  expectSameMap(*back, stored);
  EXPECT_EQ((*again)->surfaces()[0].mesh.triangles, (*document)->surfaces()[0].mesh.triangles);
  EXPECT_EQ(test::written(**again, *back), text) << "writing twice changes nothing more";
}

TEST(Obj, TrianglesKeepEveryCornersOwnUv) {
  Result<DocumentPtr> document =
      openText("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n");
  ASSERT_TRUE(document.hasValue());
  const UvMap map = cornerMap((*document)->surfaces()[0].mesh);
  Result<DocumentPtr> again = openText("t.obj", test::written(**document, map));
  ASSERT_TRUE(again.hasValue());
  expectSameMap(*(*again)->existingUv(0, 0), map);
}

TEST(Obj, ASeamOnADiagonalMovesToThePolygonsSides) {
  // Two quads; the inner diagonal of the first one is a seam turned by a quarter.
  Result<DocumentPtr> document = openText(
      "q.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nf 1 2 3 4\nf 2 5 6 3\n");
  ASSERT_TRUE(document.hasValue());
  const MeshData& mesh = (*document)->surfaces()[0].mesh;
  UvMap map;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    map.cornerUv.push_back({});
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
      map.cornerUv[t][k] = static_cast<int>(map.uv.size());
      map.uv.push_back(t == 1 ? Vec2{-p[1] + 5, p[0] + 7} : Vec2{p[0], p[1]});
    }
  }
  const UvMap stored = (*document)->asStored(0, map);
  for (std::size_t t = 0; t < 2; ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
      EXPECT_EQ(stored.uv[static_cast<std::size_t>(stored.cornerUv[t][k])], (Vec2{p[0], p[1]}));
    }
  }
  EXPECT_LE(stored.uv.size(), 4u + 6u);
  Result<DocumentPtr> again = openText("q.obj", test::written(**document, map));
  ASSERT_TRUE(again.hasValue());
  expectSameMap(*(*again)->existingUv(0, 0), stored);
}

TEST(Obj, ConcavePolygonsAreCutInside) {
  // An L with its reflex corner at (1, 1), in the plane z = x.
  Result<DocumentPtr> document = openText("l.obj",
                                          "v 0 0 0\nv 2 0 2\nv 2 1 2\nv 1 1 1\nv 1 2 1\nv 0 2 0\n"
                                          "f 1 2 3 4 5 6\n");
  ASSERT_TRUE(document.hasValue());
  const MeshData& mesh = (*document)->surfaces()[0].mesh;
  ASSERT_EQ(mesh.triangles.size(), 4u);
  double area = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(t[k])]; };
    const double cross = (at(1)[0] - at(0)[0]) * (at(2)[1] - at(0)[1]) -
                         (at(1)[1] - at(0)[1]) * (at(2)[0] - at(0)[0]);
    EXPECT_GT(cross, 0);
    area += cross / 2;
  }
  EXPECT_DOUBLE_EQ(area, 3);
}

TEST(Obj, EmbeddedConesComeBackAndAreReplaced) {
  Result<DocumentPtr> document = openText("a.obj", kMixed);
  ASSERT_TRUE(document.hasValue());
  WriteOptions options;
  options.cones = R"({"format":"hgp-cones","version":1,"q":6,"cones":[{"vertex":2,"k":5}]})";
  const UvMap map = vertexMap((*document)->surfaces()[0].mesh);
  const std::string text = test::written(**document, map, options);
  Result<DocumentPtr> again = openText("b.obj", text);
  ASSERT_TRUE(again.hasValue());
  Result<std::optional<prescription::Prescription>> cones = (*again)->embeddedCones(0);
  ASSERT_TRUE(cones.hasValue() && cones->has_value());
  EXPECT_EQ((*cones)->q, 6);
  EXPECT_EQ((*cones)->cones[0].k, 5);
  EXPECT_EQ(test::written(**again, map, options), text);
}

struct Hostile {
  const char* name;
  std::string text;
  ErrorCode code;
  int line;  ///< expected in the message, 0 when there is none
};

class HostileObj : public ::testing::TestWithParam<Hostile> {};

TEST_P(HostileObj, IsRefusedWithItsLine) {
  Result<DocumentPtr> document = openText("hostile.obj", GetParam().text);
  ASSERT_FALSE(document.hasValue());
  EXPECT_EQ(document.error().code, GetParam().code) << document.error().message;
  if (GetParam().line > 0) {
    const std::string expected = "line " + std::to_string(GetParam().line) + ":";
    EXPECT_NE(document.error().message.find(expected), std::string::npos)
        << document.error().message;
  }
}

std::string longPolygon(int corners) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf";
  for (int i = 0; i < corners; ++i) text += " 1";
  return text + "\n";
}

const std::string kThree = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

INSTANTIATE_TEST_SUITE_P(
    Table, HostileObj,
    ::testing::Values(
        Hostile{"index0", kThree + "f 0 1 2\n", ErrorCode::kMalformed, 4},
        Hostile{"outOfRange", kThree + "f 1 2 3\nf 1 2 4\n", ErrorCode::kMalformed, 5},
        Hostile{"relativeBefore", "v 0 0 0\nf -1 -2 -3\n", ErrorCode::kMalformed, 2},
        Hostile{"huge", kThree + "f 1 2 99999999999999999999\n", ErrorCode::kMalformed, 4},
        Hostile{"onlyTwoCorners", kThree + "f 1 2\n", ErrorCode::kMalformed, 0},
        Hostile{"million", longPolygon(300000), ErrorCode::kMalformed, 4},
        Hostile{"tooManyCorners", longPolygon(10001), ErrorCode::kMalformed, 4},
        Hostile{"longLine", kThree + "f " + std::string(std::size_t{1} << 21, ' ') + "1 2 3\n",
                ErrorCode::kMalformed, 4},
        Hostile{"comma", "v 0,5 0,5 0,5\n", ErrorCode::kMalformed, 1},
        Hostile{"nan", "v 0 0 nan\n", ErrorCode::kMalformed, 1},
        Hostile{"inf", "v 0 0 1e999\n", ErrorCode::kMalformed, 1},
        Hostile{"twoNumbers", "v 0 0\n", ErrorCode::kMalformed, 1},
        Hostile{"letters", kThree + "f a b c\n", ErrorCode::kMalformed, 4},
        Hostile{"tail", kThree + "f 1x 2 3\n", ErrorCode::kMalformed, 4},
        Hostile{"continued", kThree + "f 1 2 \\\n 0\n", ErrorCode::kMalformed, 4},
        Hostile{"empty", "", ErrorCode::kMalformed, 0},
        Hostile{"html", "<html></html>", ErrorCode::kMalformed, 0},
        Hostile{"nothing", "hello world\n", ErrorCode::kMalformed, 0},
        Hostile{"nul", kThree + std::string("f 1 2 3\0\n", 9), ErrorCode::kMalformed, 0},
        Hostile{"badVt", kThree + "vt a\nf 1 2 3\n", ErrorCode::kMalformed, 4}),
    [](const ::testing::TestParamInfo<Hostile>& file) { return std::string(file.param.name); });

TEST(Obj, SaysWhatATextHoldsThatIsNoSurface) {
  const auto messageOf = [](const std::string& text) {
    const Result<DocumentPtr> document = readObj(test::fileSet("a.obj", text), {});
    return document ? std::string() : document.error().message;
  };
  EXPECT_NE(messageOf(kThree + "l 1 2 3\n").find("3 vertices"), std::string::npos);
  EXPECT_NE(messageOf("hello\n").find("no v and f lines"), std::string::npos);
  // Both byte orders of UTF-16.
  for (const char* mark : {"\xFF\xFE", "\xFE\xFF"})
    EXPECT_NE(messageOf(mark + std::string("v\0 \0", 4)).find("UTF-8"), std::string::npos);
}

TEST(Obj, LimitsAreKept) {
  Limits limits;
  limits.maxTriangles = 1;
  Result<DocumentPtr> document =
      readObj(test::fileSet("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), limits);
  ASSERT_FALSE(document.hasValue());
  EXPECT_EQ(document.error().code, ErrorCode::kLimit);
  limits.maxBytes = 10;
  EXPECT_EQ(readObj(test::fileSet("a.obj", kMixed), limits).error().code, ErrorCode::kLimit);
}

/// A grid of n × n squares as OBJ text.
std::string gridText(int n) {
  std::string text;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      text += "v ";
      text::appendDouble(text, 0.001234567 * i);
      text += ' ';
      text::appendDouble(text, 0.00198765 * j);
      text += " -0.123456\n";
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j + 1;
      text += "f " + std::to_string(a) + " " + std::to_string(a + n + 1) + " " +
              std::to_string(a + 1) + "\nf " + std::to_string(a + 1) + " " +
              std::to_string(a + n + 1) + " " + std::to_string(a + n + 2) + "\n";
    }
  }
  return text;
}

/// Processor time of reading a grid of n × n squares and writing it with uv.
double secondsFor(int n) {
  const std::string text = gridText(n);
  const std::clock_t start = std::clock();
  Result<DocumentPtr> document = openText("large.obj", text);
  EXPECT_TRUE(document.hasValue());
  EXPECT_EQ((*document)->surfaces()[0].mesh.triangles.size(), 2u * static_cast<unsigned>(n * n));
  const UvMap map = vertexMap((*document)->surfaces()[0].mesh);
  EXPECT_TRUE((*document)->write(0, map, {}).hasValue());
  return double(std::clock() - start) / CLOCKS_PER_SEC;
}

TEST(Obj, ReadingAndWritingGrowsWithTheFile) {
  // 16 times as many faces; something quadratic would take 256 times as long.
  EXPECT_LT(secondsFor(240), 64 * secondsFor(60));
}

}  // namespace
}  // namespace hgp::io
