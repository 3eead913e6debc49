#include "hgp/mesh/defects.h"

#include <gtest/gtest.h>

#include <cmath>

#include "hgp/base/phrase.h"
#include "support/shapes.h"

namespace hgp {
namespace {

using Ids = std::vector<std::int64_t>;

Ids placesOf(const MeshData& data, DefectKind kind) {
  Ids ids;
  for (const Defect& d : findDefects(data))
    if (d.kind == kind)
      for (const Where& w : d.where) ids.push_back(w.id);
  return ids;
}

std::vector<DefectKind> kindsOf(const MeshData& data) {
  std::vector<DefectKind> kinds;
  for (const Defect& d : findDefects(data)) kinds.push_back(d.kind);
  return kinds;
}

using Kinds = std::vector<DefectKind>;

TEST(Defects, ShapesHaveNone) {
  for (const test::Shape& shape : test::all()) {
    EXPECT_TRUE(findDefects(shape.data).empty()) << shape.name;
    EXPECT_TRUE(requireUsable(findDefects(shape.data)));
  }
  EXPECT_TRUE(findDefects(MeshData{}).empty());
}

TEST(Defects, IndexOutOfRange) {
  for (int v : {-1, 8, 2147483647, -2147483647 - 1}) {
    MeshData data = test::cube().data;
    data.triangles[4][2] = v;
    EXPECT_EQ(placesOf(data, DefectKind::kIndexOutOfRange), Ids{4});
    EXPECT_FALSE(buildTriMesh(data));
  }
}

TEST(Defects, NotFinitePositionsOfUsedVerticesOnly) {
  for (double x : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
    MeshData data = test::cube().data;
    data.positions[5][1] = x;
    data.positions.push_back({x, x, x});
    EXPECT_EQ(placesOf(data, DefectKind::kNotFinite), Ids{5});
    EXPECT_EQ(placesOf(data, DefectKind::kIsolatedVertex), Ids{8});
    EXPECT_FALSE(buildTriMesh(data));
  }
}

TEST(Defects, IsolatedVerticesAreOnlyAWarning) {
  MeshData data = test::cube().data;
  data.positions.push_back({7, 7, 7});
  EXPECT_EQ(kindsOf(data), Kinds{DefectKind::kIsolatedVertex});
  const Result<TriMesh> mesh = buildTriMesh(data);
  ASSERT_TRUE(mesh);
  EXPECT_TRUE(mesh->isIsolated(VertexId(8)));
}

TEST(Defects, RepeatedVertex) {
  MeshData data = test::cube().data;
  data.triangles.push_back({3, 5, 3});
  EXPECT_EQ(kindsOf(data), Kinds{DefectKind::kRepeatedVertex});
  EXPECT_EQ(placesOf(data, DefectKind::kRepeatedVertex), Ids{12});
}

TEST(Defects, ZeroAreaAtAnyScale) {
  for (double scale : {1e-300, 1e-160, 1.0, 1e160, 1e300}) {
    MeshData data = test::grid(1, 1).data;
    for (Vec3& p : data.positions)
      for (double& x : p) x *= scale;
    EXPECT_TRUE(placesOf(data, DefectKind::kZeroArea).empty()) << scale;
    data.positions[2] = {0.5 * scale, 0.5 * scale, 0};
    EXPECT_FALSE(placesOf(data, DefectKind::kZeroArea).empty()) << scale;
    data.positions[2] = data.positions[0];
    EXPECT_FALSE(placesOf(data, DefectKind::kZeroArea).empty()) << scale;
    data.positions[2] = {0.5 * scale, 0.5 * scale * (1 + 1e-12), 0};
    EXPECT_TRUE(placesOf(data, DefectKind::kZeroArea).empty()) << "thin is not flat " << scale;
  }
}

TEST(Defects, DuplicateFaceInAnyOrder) {
  for (const auto& order : {std::array{0, 1, 2}, std::array{1, 2, 0}, std::array{0, 2, 1}}) {
    MeshData data = test::grid(2, 2).data;
    const auto t = data.triangles[3];
    data.triangles.push_back(
        {t[std::size_t(order[0])], t[std::size_t(order[1])], t[std::size_t(order[2])]});
    EXPECT_EQ(placesOf(data, DefectKind::kDuplicateFace), Ids{8});
  }
}

TEST(Defects, NonManifoldEdgeIsNotReportedAsVerticesToo) {
  MeshData data = test::grid(1, 1).data;
  data.positions.push_back({0, 0, 1});
  data.triangles.push_back({0, 3, 4});
  EXPECT_EQ(kindsOf(data), Kinds{DefectKind::kNonManifoldEdge});
  const auto defects = findDefects(data);
  EXPECT_EQ(defects[0].where[0].id, 0);
  EXPECT_EQ(defects[0].where[0].other, 3);
}

TEST(Defects, InconsistentEdge) {
  MeshData data = test::grid(1, 1).data;
  std::swap(data.triangles[1][0], data.triangles[1][1]);
  EXPECT_EQ(kindsOf(data), Kinds{DefectKind::kInconsistentEdge});
}

TEST(Defects, NonManifoldVertex) {
  MeshData data{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(kindsOf(data), Kinds{DefectKind::kNonManifoldVertex});
  EXPECT_EQ(placesOf(data, DefectKind::kNonManifoldVertex), Ids{0});
}

TEST(Defects, EveryKindHasItsCode) {
  const std::pair<DefectKind, const char*> kinds[] = {
      {DefectKind::kIndexOutOfRange, "defect-index-out-of-range"},
      {DefectKind::kNotFinite, "defect-not-finite"},
      {DefectKind::kExtent, "defect-extent"},
      {DefectKind::kRepeatedVertex, "defect-repeated-vertex"},
      {DefectKind::kZeroArea, "defect-zero-area"},
      {DefectKind::kDuplicateFace, "defect-duplicate-face"},
      {DefectKind::kNonManifoldEdge, "defect-non-manifold-edge"},
      {DefectKind::kInconsistentEdge, "defect-inconsistent-edge"},
      {DefectKind::kNonManifoldVertex, "defect-non-manifold-vertex"}};
  for (const auto& [kind, code] : kinds) {
    const Note note = noteOn({kind, {{Where::Kind::kVertex, 3}}});
    EXPECT_EQ(note.code, code);
    EXPECT_NE(phrase(note), code) << "it is in the catalogue";
    EXPECT_EQ(note.where, (std::vector<Where>{{Where::Kind::kVertex, 3}}));
  }
  const std::vector<Where> many(9, {Where::Kind::kVertex, 3});
  EXPECT_EQ(noteOn({DefectKind::kZeroArea, many}).where.size(), 5u);
}

TEST(Defects, RefusalNamesRuleCountPlacesAndRemedy) {
  MeshData data = test::grid(1, 1).data;
  data.positions.push_back({0, 0, 1});
  data.triangles.push_back({0, 3, 4});
  const Status status = requireUsable(findDefects(data));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kUnsupported);
  const Note expected("defect-non-manifold-edge", {{"count", 1}, {"only", 1}},
                      {{Where::Kind::kEdge, 0, 3}});
  EXPECT_EQ(status.error().message, phrase(expected) + ".");
  EXPECT_EQ(status.error().advice, Notes{Note("repair-with", {{"fixes", "split"}})});
  EXPECT_EQ(told(status.error()), phrase(expected) + ". Repair with --fix split.");
  EXPECT_EQ(status.error().where.size(), 1u);
}

}  // namespace
TEST(Defects, ExtentsBeyondDoubleArithmeticAreNamed) {
  for (double scale : {1e19, 1e300, 1e-101, 1e-310}) {
    const MeshData data{{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}}, {{0, 1, 2}}};
    const std::vector<Defect> defects = findDefects(data);
    ASSERT_EQ(defects.size(), 1u) << scale;
    EXPECT_EQ(defects[0].kind, DefectKind::kExtent);
    EXPECT_EQ(defects[0].where.size(), 2u);
    EXPECT_FALSE(requireUsable(defects).hasValue());
  }
  for (double scale : {1e18, 1.0, 1e-30, 1e-99}) {
    const MeshData data{{{0, 0, 0}, {scale, 0, 0}, {0, scale, 0}}, {{0, 1, 2}}};
    EXPECT_TRUE(findDefects(data).empty()) << scale;
  }
}

}  // namespace hgp
