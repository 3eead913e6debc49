#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

#include "hgp/mesh/defects.h"
#include "hgp/mesh/geometry.h"
#include "hgp/mesh/topology.h"
#include "support/notes.h"
#include "support/shapes.h"

namespace hgp {
namespace {

constexpr FixOptions kOrient{true, false, false}, kSplit{false, true, false},
    kDegenerate{false, false, true}, kAll{true, true, true};

double volume(const MeshData& data) {
  double sum = 0.0;
  for (const auto& t : data.triangles) {
    const Vec3 &a = data.positions[std::size_t(t[0])], &b = data.positions[std::size_t(t[1])],
               &c = data.positions[std::size_t(t[2])];
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
            a[2] * (b[0] * c[1] - b[1] * c[0])) /
           6;
  }
  return sum;
}

std::string messageOf(const FixResult& result) {
  const Status status = requireUsable(findDefects(result.mesh), true);
  return status ? "" : status.error().message;
}

bool isWellFormed(const FixResult& r, const MeshData& before) {
  bool ok = r.faceOrigin.size() == r.mesh.triangles.size() &&
            r.vertexOrigin.size() == r.mesh.positions.size();
  for (int f : r.faceOrigin) ok = ok && f >= 0 && f < static_cast<int>(before.triangles.size());
  for (int v : r.vertexOrigin) ok = ok && v >= 0 && v < static_cast<int>(before.positions.size());
  return ok;
}

TEST(Repair, LeavesGoodMeshesAlone) {
  for (const test::Shape& shape : test::all()) {
    const FixResult r = fixDefects(shape.data, kAll);
    EXPECT_EQ(r.mesh.triangles, shape.data.triangles) << shape.name;
    EXPECT_EQ(r.mesh.positions, shape.data.positions);
    EXPECT_TRUE(r.notes.empty()) << r.notes[0].code;
  }
}

TEST(Repair, NothingIsRepairedUnlessRequested) {
  MeshData data = test::grid(1, 1).data;
  std::swap(data.triangles[1][0], data.triangles[1][1]);
  EXPECT_EQ(fixDefects(data, {}).mesh.triangles, data.triangles);
}

TEST(Repair, FewFacesThatDisagreeAreTheOnesThatAreFlipped) {
  // Even where the surface is inside out, or the first face is one of them.
  for (const bool isInsideOut : {false, true})
    for (const std::size_t first : {std::size_t{0}, std::size_t{3}}) {
      MeshData data = test::icosphere(3).data;
      if (isInsideOut)
        for (auto& t : data.triangles) std::swap(t[0], t[1]);
      const auto before = data.triangles;
      for (const std::size_t f : {first, std::size_t{40}})
        std::swap(data.triangles[f][1], data.triangles[f][2]);
      const FixResult r = fixDefects(data, {true, false, false});
      EXPECT_EQ(r.mesh.triangles, before) << isInsideOut << ", from " << first;
    }
}

TEST(Repair, OrientsShuffledFacesOutwards) {
  std::mt19937 random(3);
  for (const test::Shape& shape : test::closed()) {
    MeshData data = shape.data;
    for (auto& t : data.triangles)
      if (random() % 2) std::swap(t[0], t[1]);
    const FixResult r = fixDefects(data, kOrient);
    EXPECT_EQ(messageOf(r), "") << shape.name;
    EXPECT_NEAR(volume(r.mesh), volume(shape.data), 1e-12);
  }
}

TEST(Repair, OrientsSurfacesWithBoundaryByMajority) {
  for (const test::Shape& shape : test::withBoundary()) {
    if (shape.data.triangles.size() < 4) continue;
    MeshData data = shape.data;
    std::swap(data.triangles[1][0], data.triangles[1][2]);
    const FixResult r = fixDefects(data, kOrient);
    EXPECT_EQ(messageOf(r), "") << shape.name;
    const TriMesh a = test::meshOf(r.mesh), b = shape.mesh();
    EXPECT_EQ(a.head(HalfedgeId(0)), b.head(HalfedgeId(0)));
  }
}

TEST(Repair, AMoebiusBandIsCutOnceOrStaysADefect) {
  MeshData data;
  const int n = 9;
  for (int i = 0; i < n; ++i)
    for (int side = 0; side < 2; ++side) {
      const double a = 6.283185307179586 * i / n, b = a / 2, w = side ? 0.3 : -0.3;
      data.positions.push_back({(1 + w * std::cos(b)) * std::cos(a),
                                (1 + w * std::cos(b)) * std::sin(a), w * std::sin(b)});
    }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    data.triangles.push_back({a, c, b});
    data.triangles.push_back({b, c, d});
  }
  FixOptions orient;
  orient.orient = true;
  const auto defects = findDefects(fixDefects(data, orient).mesh);
  ASSERT_EQ(defects.size(), 1u);
  EXPECT_EQ(defects[0].kind, DefectKind::kInconsistentEdge);
  const FixResult cut = fixDefects(data, kAll);
  EXPECT_TRUE(findDefects(cut.mesh).empty());
  EXPECT_EQ(cut.mesh.triangles.size(), data.triangles.size());
  EXPECT_EQ(cut.mesh.positions.size(), data.positions.size() + 2);
}

TEST(Repair, SplitsTwoFansAtAVertex) {
  const MeshData data{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                      {{0, 1, 2}, {0, 3, 4}}};
  const FixResult r = fixDefects(data, kSplit);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(r.mesh.positions.size(), 6u);
  EXPECT_EQ(r.vertexOrigin[5], 0);
}

TEST(Repair, TwoCubesTouchingAlongAnEdgeAreSeparated) {
  MeshData data = test::cube(2).data;
  const MeshData other = data;
  // The second cube is moved by (1, 1, 0) and glued where it meets the first.
  std::vector<int> id;
  for (const Vec3& p : other.positions) {
    const Vec3 moved{p[0] + 1, p[1] + 1, p[2]};
    const auto it = std::find(data.positions.begin(), data.positions.end(), moved);
    id.push_back(static_cast<int>(it - data.positions.begin()));
    if (it == data.positions.end()) data.positions.push_back(moved);
  }
  for (const auto& t : other.triangles)
    data.triangles.push_back({id[std::size_t(t[0])], id[std::size_t(t[1])], id[std::size_t(t[2])]});
  EXPECT_FALSE(buildTriMesh(data));
  const FixResult r = fixDefects(data, kSplit);
  EXPECT_EQ(messageOf(r), "");
  const TriMesh mesh = test::meshOf(r.mesh);
  const Topology topology = computeTopology(mesh);
  EXPECT_EQ(topology.componentCount, 2);
  EXPECT_TRUE(topology.loops.empty());
  EXPECT_EQ(topology.genus, 0);
  EXPECT_TRUE(isWellFormed(r, data));
}

TEST(Repair, AThirdFaceOnAnEdgeIsCutOff) {
  MeshData data = test::grid(3, 3).data;
  data.positions.push_back({1, 1, 1});
  data.triangles.push_back({0, 5, 16});
  EXPECT_FALSE(buildTriMesh(data));
  const FixResult r = fixDefects(data, kSplit);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(computeTopology(test::meshOf(r.mesh)).componentCount, 2);
}

TEST(Repair, RandomSoupsBecomeManifold) {
  std::mt19937 random(17);
  for (int round = 0; round < 200; ++round) {
    MeshData data;
    const int vertices = 4 + static_cast<int>(random() % 9);
    for (int v = 0; v < vertices; ++v)
      data.positions.push_back(
          {double(random() % 1000), double(random() % 1000), double(random() % 1000)});
    for (int f = 0; f < 3 * vertices; ++f) {
      std::array<int, 3> t{};
      for (int& v : t) v = static_cast<int>(random() % static_cast<unsigned>(vertices));
      data.triangles.push_back(t);
    }
    const FixResult r = fixDefects(data, kAll);
    ASSERT_TRUE(isWellFormed(r, data));
    for (const Defect& d : findDefects(r.mesh))
      EXPECT_TRUE(d.kind == DefectKind::kIsolatedVertex || d.kind == DefectKind::kInconsistentEdge)
          << round << " " << defectName(d.kind);
  }
}

/// The metric of a mesh with faces without area: a metric, hardly another one, and of the same surface.
void expectMetric(const test::Shape& shape, const MeshData& data) {
  EXPECT_FALSE(buildTriMesh(data)) << shape.name << ": only where it is allowed";
  const Result<TriMesh> built = buildTriMesh(data, true);
  ASSERT_TRUE(built) << shape.name;
  const TriMesh& mesh = *built;
  const Geometry g = computeGeometry(mesh);
  EXPECT_GE(g.mollified, kMollify) << shape.name;
  EXPECT_LE(g.mollified, 1.01 * kMollify);
  double total = 0.0;
  for (FaceId f : mesh.faces()) {
    EXPECT_GT(g.area[f], 0.0);
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      EXPECT_GE(g.length[h] + g.length[TriMesh::next(h)] - g.length[TriMesh::previous(h)], 0.0);
      EXPECT_GT(g.cornerAngle[h], 0.0);
      const double across = g.length[mesh.isBoundary(h) ? h : mesh.twin(h)];
      EXPECT_NEAR(g.length[h], across, 2e-6 * (1 + g.length[h]));
    }
  }
  for (VertexId v : mesh.vertices()) total += curvature(mesh, g, v);
  EXPECT_NEAR(total, 2 * kPi * (2 - 2 * shape.genus - shape.loops), 1e-9) << shape.name;
}

TEST(Repair, CapsStayAsTheyAre) {
  // A cap: a vertex in the middle of a side, found on every kind of surface.
  for (const test::Shape& shape : test::closed()) {
    MeshData data = shape.data;
    const auto t = data.triangles[0];
    const int m = static_cast<int>(data.positions.size());
    Vec3 middle;
    for (std::size_t n = 0; n < 3; ++n)
      middle[n] = (data.positions[std::size_t(t[0])][n] + data.positions[std::size_t(t[1])][n]) / 2;
    data.positions.push_back(middle);
    // Face 0 is split at m, the neighbour keeps its side and a flat face fills the slit.
    data.triangles[0] = {m, t[1], t[2]};
    data.triangles.push_back({t[0], m, t[2]});
    data.triangles.push_back({t[0], t[1], m});
    const auto kinds = findDefects(data);
    ASSERT_EQ(kinds.size(), 1u) << shape.name;
    const FixResult r = fixDefects(data, kDegenerate);
    EXPECT_EQ(messageOf(r), "") << shape.name;
    EXPECT_EQ(r.mesh.triangles, data.triangles);
    EXPECT_EQ(r.mesh.positions, data.positions);
    EXPECT_TRUE(r.leftOut.empty());
    expectMetric(shape, r.mesh);
  }
}

TEST(Repair, NeedlesStayAsTheyAre) {
  std::mt19937 random(23);
  for (const test::Shape& shape : {test::icosphere(4), test::torus(9, 9), test::doubleTorus(3),
                                   test::disk(6), test::annulus(9, 4)}) {
    // Vertices jump onto a neighbour of theirs: every such edge leaves two needles.
    MeshData data = shape.data;
    for (int n = 0; n < 6; ++n) {
      const auto& t = data.triangles[random() % data.triangles.size()];
      data.positions[std::size_t(t[0])] = data.positions[std::size_t(t[1])];
    }
    const FixResult r = fixDefects(data, kDegenerate);
    EXPECT_EQ(messageOf(r), "") << shape.name;
    EXPECT_EQ(r.mesh.triangles, data.triangles);
    expectMetric(shape, r.mesh);
  }
}

TEST(Repair, HealthyMeshesAreNotMollified) {
  for (const test::Shape& shape : test::all())
    EXPECT_EQ(computeGeometry(shape.mesh()).mollified, 0.0) << shape.name;
}

TEST(Repair, ComponentsWithoutAnyAreaAreLeftOut) {
  MeshData data = test::icosphere(2).data;
  const auto faces = data.triangles.size();
  const int first = static_cast<int>(data.positions.size());
  for (int n = 0; n < 4; ++n) data.positions.push_back({5, 5, 5});
  data.triangles.push_back({first, first + 1, first + 2});
  data.triangles.push_back({first, first + 2, first + 3});
  const FixResult r = fixDefects(data, kDegenerate);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(r.mesh.triangles.size(), faces);
  ASSERT_EQ(r.leftOut.size(), 2u);
  for (const LeftOutFace& left : r.leftOut) {
    EXPECT_EQ(left.why, LeftOut::kZeroArea);
    EXPECT_EQ(left.twin, -1);
  }
  for (Vec3& p : data.positions) p = {1, 2, 3};
  EXPECT_TRUE(fixDefects(data, kDegenerate).mesh.triangles.empty());
}

TEST(Repair, RemovesFacesThatNameAVertexTwice) {
  // Two vertices of an edge become one number: what welding by position leaves behind.
  MeshData data = test::icosphere(4).data;
  const auto t = data.triangles[17];
  for (auto& u : data.triangles)
    for (int& v : u)
      if (v == t[0]) v = t[1];
  const FixResult r = fixDefects(data, kDegenerate);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(r.mesh.triangles.size(), data.triangles.size() - 2);
  EXPECT_EQ(r.leftOut.size(), 2u);
  EXPECT_TRUE(computeTopology(test::meshOf(r.mesh)).loops.empty());
}

TEST(Repair, KeepsOneOfEveryPairOfFacesInADoubleSidedSheet) {
  MeshData data = test::grid(3, 3).data;
  const MeshData once = data;
  for (const auto& t : once.triangles) data.triangles.push_back({t[1], t[0], t[2]});
  const FixResult r = fixDefects(data, kAll);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(r.mesh.triangles.size(), once.triangles.size());
  ASSERT_EQ(r.leftOut.size(), once.triangles.size());
  for (const LeftOutFace& left : r.leftOut) {
    EXPECT_EQ(left.why, LeftOut::kDuplicate);
    auto a = data.triangles[std::size_t(left.face)], b = data.triangles[std::size_t(left.twin)];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    EXPECT_EQ(a, b);
    EXPECT_EQ(std::count(r.faceOrigin.begin(), r.faceOrigin.end(), left.twin), 1);
  }
  EXPECT_EQ(computeTopology(test::meshOf(r.mesh)).loops.size(), 1u);
}

TEST(Repair, AFinFoldedBackOnItselfIsSeparatedAsOneSheet) {
  MeshData data = test::icosphere(3).data;
  const auto t = data.triangles[5];
  data.positions.push_back({3, 3, 3});
  const int tip = static_cast<int>(data.positions.size()) - 1;
  data.triangles.push_back({t[0], t[1], tip});
  data.triangles.push_back({t[1], t[0], tip});
  const FixResult r = fixDefects(data, kAll);
  EXPECT_EQ(messageOf(r), "");
  EXPECT_EQ(r.mesh.triangles.size(), data.triangles.size() - 1);
  ASSERT_EQ(r.leftOut.size(), 1u);
  EXPECT_EQ(r.leftOut[0].why, LeftOut::kDuplicate);
  const Topology topology = computeTopology(test::meshOf(r.mesh));
  EXPECT_EQ(topology.componentCount, 2);
  EXPECT_EQ(topology.loops.size(), 1u);
}

TEST(Repair, AQuantizedScanStaysWatertight) {
  // Coordinates rounded to a coarse grid, as a file with few bits has them: hundreds of faces lose
  // their area, alone and in clusters.
  for (const test::Shape& shape :
       {test::jittered(test::torus(160, 90), 0.004), test::jittered(test::icosphere(40), 0.004)}) {
    MeshData data = shape.data;
    for (Vec3& p : data.positions)
      for (double& x : p) x = std::round(x * 32) / 32;
    std::size_t flat = 0;
    for (const Defect& d : findDefects(data))
      if (d.kind == DefectKind::kZeroArea) flat = d.where.size();
    ASSERT_GT(flat, 20u);
    const FixResult r = fixDefects(data, kAll);
    EXPECT_EQ(messageOf(r), "") << shape.name;
    EXPECT_NEAR(volume(r.mesh), volume(data), 1e-3 * volume(data));
    const Result<TriMesh> mesh = buildTriMesh(r.mesh, true);
    ASSERT_TRUE(mesh);
    EXPECT_TRUE(computeTopology(*mesh).loops.empty());
    EXPECT_EQ(computeTopology(*mesh).genus, shape.genus);
    const Geometry g = computeGeometry(*mesh);
    for (FaceId f : mesh->faces()) EXPECT_GT(g.area[f], 0.0);
  }
}

TEST(Repair, RefusesToTouchIndicesOutOfRange) {
  MeshData data = test::cube().data;
  data.triangles[0][0] = 99;
  const FixResult r = fixDefects(data, kAll);
  EXPECT_EQ(r.mesh.triangles, data.triangles);
  EXPECT_EQ(test::codesOf(r.notes), test::Codes{"repair-none"});
}

}  // namespace
}  // namespace hgp
