// Certified maps of polygons: what is stored for every polygon, not only for the triangles hgp cut it into.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

#include "hgp/api/session.h"
#include "hgp/verify/orientation.h"

namespace hgp::api {
namespace {

using Json = nlohmann::json;

struct Text {
  std::vector<Vec3> positions;
  std::vector<std::vector<int>> rings;
  std::string obj() const {
    std::ostringstream out;
    out.precision(17);
    for (const Vec3& p : positions) out << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    for (const auto& ring : rings) {
      out << 'f';
      for (const int v : ring) out << ' ' << v + 1;
      out << '\n';
    }
    return out.str();
  }
};

/// A tube of quadrilaterals, open at both ends, with vertices moved at random.
Text tube(int m, int n, double amount, unsigned seed) {
  Text out;
  std::mt19937 random(seed);
  std::uniform_real_distribution noise(-amount, amount);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i < m; ++i) {
      const double a = 6.283185307179586 * i / m;
      out.positions.push_back(
          {std::cos(a) + noise(random), std::sin(a) + noise(random), 0.4 * j + noise(random)});
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < m; ++i)
      out.rings.push_back(
          {j * m + i, j * m + (i + 1) % m, (j + 1) * m + (i + 1) % m, (j + 1) * m + i});
  return out;
}

void addDoublet(Text& text, std::size_t at, double z) {
  const std::vector<int> ring = text.rings[at];
  Vec3 middle{0, 0, z};
  for (const int v : ring)
    for (std::size_t k = 0; k < 3; ++k)
      middle[k] += text.positions[static_cast<std::size_t>(v)][k] / 4;
  const int x = static_cast<int>(text.positions.size());
  text.positions.push_back(middle);
  text.rings[at] = {ring[0], ring[1], ring[2], x};
  text.rings.push_back({ring[0], x, ring[2], ring[3]});
}

Session loaded(const std::string& obj) {
  Session session;
  io::FileSet files;
  files.name = "mesh.obj";
  files.main.assign(obj.begin(), obj.end());
  const Status done = session.load(std::move(files), {});
  EXPECT_TRUE(done) << (done ? "" : done.error().message);
  return session;
}

/// The uv of every polygon of an OBJ, read independently of the reader under test.
std::vector<std::vector<Vec2>> uvOfPolygons(const std::string& text) {
  std::vector<Vec2> uv;
  std::vector<std::vector<Vec2>> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "vt") {
      Vec2 p;
      words >> p[0] >> p[1];
      uv.push_back(p);
    } else if (word == "f") {
      out.emplace_back();
      while (words >> word)
        out.back().push_back(
            uv[static_cast<std::size_t>(std::stoi(word.substr(word.find('/') + 1)) - 1)]);
    }
  }
  return out;
}

/// Whether one of the two diagonals of a quadrilateral has two positive triangles; a triangle is positive itself.
bool isPositive(const std::vector<Vec2>& p) {
  const auto sign = [&](std::size_t a, std::size_t b, std::size_t c) {
    return orientationSign(p[a], p[b], p[c]);
  };
  if (p.size() == 3) return sign(0, 1, 2) > 0;
  return (sign(0, 1, 2) > 0 && sign(0, 2, 3) > 0) || (sign(0, 1, 3) > 0 && sign(1, 2, 3) > 0);
}

bool isConvex(const std::vector<Vec2>& p) {
  for (std::size_t i = 0; i < p.size(); ++i)
    if (orientationSign(p[i], p[(i + 1) % p.size()], p[(i + 2) % p.size()]) <= 0) return false;
  return true;
}

std::string certified(Session& session, const SolveOptions& options, const std::string& name) {
  const Status done = session.parametrize(std::nullopt, options);
  EXPECT_TRUE(done) << name << (done ? "" : done.error().message);
  EXPECT_TRUE(done && session.isCertified()) << name << session.certificateJson();
  WriteOptions write;
  write.name = "out.obj";
  const Result<WrittenMap> written = session.write(write);
  EXPECT_TRUE(written) << name;
  if (!written) return "";
  const io::Bytes& bytes = written->files[0].bytes;
  return {bytes.begin(), bytes.end()};
}

TEST(Polygons, DoubletsAreCertifiedAndEveryPolygonIsPositive) {
  std::mt19937 random(11);
  for (unsigned seed = 0; seed < 12; ++seed) {
    Text text = tube(9, 5, 0.02, seed);
    for (int n = 0; n < 4; ++n)
      addDoublet(text, random() % text.rings.size(), 0.2 * static_cast<double>(random() % 5) - 0.4);
    Session session = loaded(text.obj());
    const std::string out = certified(session, {}, std::to_string(seed));
    const Json stored = Json::parse(session.certificateJson())["stored"];
    EXPECT_EQ(stored["duplicates"], 0) << seed;
    EXPECT_EQ(stored["verified"], 2 * text.rings.size());
    for (const auto& polygon : uvOfPolygons(out)) EXPECT_TRUE(isPositive(polygon)) << seed;
  }
}

TEST(Polygons, TheFamousHeadIsCertifiedAsItComes) {
  const char* given = std::getenv("HGP_SHARED_MESHES");
  const std::string folder = std::string(given ? given : HGP_SHARED_MESHES_DEFAULT) + "/../cases";
  for (const char* name : {"messy/doublet.obj", "hard/suzanne.obj", "hard/monkey.obj"}) {
    std::ifstream file(folder + "/" + name, std::ios::binary);
    if (!file) GTEST_SKIP() << "optional data are not there: " << folder << "/" << name;
    const std::string text(std::istreambuf_iterator<char>(file), {});
    Session session = loaded(text);
    const std::string out = certified(session, {}, name);
    EXPECT_EQ(Json::parse(session.certificateJson())["stored"]["duplicates"], 0) << name;
    for (const auto& polygon : uvOfPolygons(out)) ASSERT_TRUE(isPositive(polygon)) << name;
  }
}

TEST(Polygons, ThoseThatAreNotConvexInTheMapAreCounted) {
  const Text text = tube(14, 10, 0.16, 2);
  Session session = loaded(text.obj());
  const std::string out = certified(session, {}, "tube");
  int count = 0;
  for (const auto& polygon : uvOfPolygons(out)) count += !isConvex(polygon);
  const Json stored = Json::parse(session.certificateJson())["stored"];
  EXPECT_GT(count, 0);
  EXPECT_EQ(stored["notConvex"], count);
  EXPECT_EQ(stored["polygons"], text.rings.size());
  Session again = loaded(out);
  const Result<Verdict> verdict = again.verify(std::nullopt, {});
  ASSERT_TRUE(verdict);
  EXPECT_EQ(Json::parse(verdict->json)["stored"], stored);
}

TEST(Polygons, ConvexOnesOnRequest) {
  int before = 0, after = 0, certifiedAfter = 0;
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Text text = tube(14, 10, 0.18, seed);
    Session session = loaded(text.obj());
    certified(session, {}, "as solved");
    before += Json::parse(session.certificateJson())["stored"]["notConvex"].get<int>();
    SolveOptions options;
    options.convexPolygons = true;
    ASSERT_TRUE(session.parametrize(std::nullopt, options));
    const int left = Json::parse(session.certificateJson())["stored"]["notConvex"];
    after += left;
    EXPECT_EQ(session.isCertified(), left == 0) << seed << session.certificateJson();
    if (!session.isCertified()) continue;
    ++certifiedAfter;
    for (const auto& polygon : uvOfPolygons(certified(session, options, "convex")))
      EXPECT_TRUE(isConvex(polygon)) << seed;
  }
  EXPECT_GE(before, 5);
  EXPECT_LT(4 * after, before);
  EXPECT_GE(certifiedAfter, 2);
}

/// A square after three of its halves as faces of their own: along either diagonal a half is a copy. Each face has its
/// own uv, congruent to it; two of them mirrored, with the opposite winding.
std::string squareWithCopies(const std::string& uvOfCorner) {
  return "v 0 -1 0\nv 1 0 0\nv 0 1 0\nv -1 0 0\n"
         "vt 0 -1\nvt 1 0\nvt 0 1\nvt -1 0\nvt " +
         uvOfCorner + "\nf 3/3 2/4 1/1\nf 2/2 3/3 4/4\nf 2/4 1/1 4/2\nf 1/1 2/2 3/5 4/4\n";
}

TEST(Polygons, APartThatRepeatsAFaceIsNotCertifiedFolded) {
  for (const char* folded : {"0 -0.5", "0.1 -0.3"}) {
    const Result<Verdict> verdict = loaded(squareWithCopies(folded)).verify(std::nullopt, {});
    ASSERT_TRUE(verdict) << (verdict ? "" : verdict.error().message);
    EXPECT_FALSE(verdict->isGood) << verdict->json;
    EXPECT_NE(verdict->json.find("1 polygon has a part that repeats a face and is folded"),
              std::string::npos)
        << verdict->json;
  }
  const Result<Verdict> flat = loaded(squareWithCopies("0 1")).verify(std::nullopt, {});
  ASSERT_TRUE(flat);
  EXPECT_TRUE(flat->isGood) << flat->json;
}

}  // namespace
}  // namespace hgp::api
