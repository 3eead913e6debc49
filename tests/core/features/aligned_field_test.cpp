// Fields along features.  Laws: features follow directions of the field; all integers agree with the angles; every patch
// satisfies Gauss–Bonnet; indices are possible.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "hgp/base/disjoint_sets.h"
#include "hgp/features/field_along.h"
#include "hgp/features/fitted_field.h"
#include "hgp/features/index_flow.h"
#include "support/creases.h"

namespace hgp {
namespace {

constexpr double kQuarter = kPi / 2.0;

Result<AlignedField> fieldOf(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  return alignedField(mesh, prepareSurface(mesh), features);
}

/// Σ over the corners of a node of α − ω behind them, and the tilts of a sector, in quarter turns.
std::vector<double> anglesOfNodes(const TriMesh& mesh, const AlignedField& field) {
  const Geometry geometry = computeGeometry(mesh);
  std::vector<double> sum(field.index.size(), 0.0);
  for (HalfedgeId h : mesh.halfedges()) {
    const HalfedgeId into = TriMesh::previous(h);
    double& node = sum[at(field.sectors.node(mesh, h))];
    node += geometry.cornerAngle[h];
    if (field.sectors.isFeature[mesh.edge(into)]) {
      node += field.tilt[into];
    } else {
      node -= field.turn[into];
    }
    if (field.sectors.isFeature[mesh.edge(h)]) node -= field.tilt[h];
  }
  for (double& s : sum) s /= kQuarter;
  return sum;
}

void expectLaws(const std::string& name, const TriMesh& mesh, const AlignedField& field) {
  const Geometry geometry = computeGeometry(mesh);
  const std::vector<double> measured = anglesOfNodes(mesh, field);
  for (std::size_t n = 0; n < measured.size(); ++n) {
    const bool isUnused =
        n < at(mesh.vertexCount()) && field.sectors.isOnFeature[VertexId(static_cast<int>(n))];
    if (isUnused) continue;
    EXPECT_NEAR(measured[n], field.index[n], 1e-9) << name << " node " << n;
    EXPECT_GE(field.index[n], 1) << name;
    EXPECT_LE(field.index[n], largestIndex(mesh, field.sectors, static_cast<int>(n))) << name;
  }
  for (HalfedgeId h : mesh.halfedges()) {
    const FaceId f = TriMesh::face(h);
    if (field.sectors.isFeature[mesh.edge(h)]) {
      EXPECT_NEAR(std::remainder(field.axis[h] * kQuarter - geometry.direction[h] +
                                     field.field.angle[f] - field.tilt[h],
                                 2.0 * kPi),
                  0.0, 1e-9)
          << name;
    }
    if (mesh.isBoundary(h)) continue;
    EXPECT_EQ(field.field.matching[h], -field.field.matching[mesh.twin(h)]);
    const double turn = field.field.angle[TriMesh::face(mesh.twin(h))] +
                        field.field.matching[h] * kQuarter - field.field.angle[f] -
                        transport(mesh, geometry, h);
    EXPECT_NEAR(std::remainder(turn - field.turn[h], 2.0 * kPi), 0.0, 1e-9) << name;
  }
}

/// Σ_inner (4 − k) + Σ_sectors (2 − a) − 4 χ of every patch must vanish.
void expectGaussBonnet(const std::string& name, const TriMesh& mesh, const AlignedField& field) {
  const Sectors& sectors = field.sectors;
  DisjointSets patches(mesh.faceCount());
  for (HalfedgeId h : mesh.halfedges())
    if (!mesh.isBoundary(h) && !sectors.isFeature[mesh.edge(h)])
      patches.join(TriMesh::face(h).i, TriMesh::face(mesh.twin(h)).i);
  // A patch is cut open along Γ: every sector is a vertex of its own, every side of a feature an edge of its own.
  std::map<int, int> sum;
  for (FaceId f : mesh.faces()) sum[patches.root(f.i)] -= 4;
  for (HalfedgeId h : mesh.halfedges())
    if (sectors.isFeature[mesh.edge(h)] || h < mesh.twin(h))
      sum[patches.root(TriMesh::face(h).i)] += 4;
  for (const Sector& s : sectors.list) {
    const int a = field.index[at(sectors.node(mesh, s.first))];
    sum[patches.root(TriMesh::face(s.first).i)] += 2 - a - 4;
  }
  for (VertexId v : mesh.vertices())
    if (!sectors.isOnFeature[v])
      sum[patches.root(TriMesh::face(mesh.outgoing(v)).i)] += 4 - field.index[at(v.i)] - 4;
  for (const auto& [patch, value] : sum) EXPECT_EQ(value, 0) << name << " patch " << patch;
}

TEST(AlignedField, HasIntegersThatAgreeWithItsAngles) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    const Result<AlignedField> field = fieldOf(shape.mesh, shape.features);
    ASSERT_TRUE(field) << shape.name;
    expectLaws(shape.name, shape.mesh, *field);
    expectGaussBonnet(shape.name, shape.mesh, *field);
  }
}

TEST(AlignedField, TurnsByAQuarterInEverySectorOfACube) {
  const TriMesh mesh = test::cube(4).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  EXPECT_EQ(features.size(), 12u * 4u);
  const Result<AlignedField> field = fieldOf(mesh, features);
  ASSERT_TRUE(field);
  int corners = 0;
  for (const Sector& s : field->sectors.list) {
    const int a = field->index[at(field->sectors.node(mesh, s.first))];
    corners += a == 1;
    EXPECT_TRUE(a == 1 || a == 2);
  }
  EXPECT_EQ(corners, 24);
  const CompleteSpec spec =
      specOf(mesh, computeTopology(mesh), handleGenerators(mesh), *field, features);
  EXPECT_EQ(spec.cones.size(), 8u);
  for (const ConePoint& cone : spec.cones) EXPECT_EQ(cone.k, 3);
  EXPECT_EQ(spec.features, features);
}

/// A parallelogram with two angles of 20°, split so that three triangles share each of them.
TriMesh sharpMesh() {
  MeshData data = test::grid(6, 6).data;
  for (Vec3& p : data.positions) p = {p[0] + p[1] * 2.75, p[1], 0.0};
  return test::meshOf(data);
}

TEST(AlignedField, MovesUnitsWhereASectorWouldHaveNone) {
  const TriMesh mesh = sharpMesh();
  const Result<AlignedField> field = fieldOf(mesh, test::creasesOf(mesh));
  ASSERT_TRUE(field);
  EXPECT_GT(field->moved, 0);
  expectLaws("parallelogram", mesh, *field);
  expectGaussBonnet("parallelogram", mesh, *field);
}

TEST(AlignedField, KeepsUnitsThatArePossible) {
  for (const test::CreasedShape& shape : test::creasedShapes())
    EXPECT_EQ(fieldOf(shape.mesh, shape.features)->moved, 0) << shape.name;
}

TEST(AlignedField, RightAnglesBetweenFeaturesLeaveTheirNeighboursLess) {
  // Of the two triangles of a square's corner, none has its right angle there; those of the other corners have.
  const TriMesh mesh = test::cube(1).mesh();
  const Sectors sectors = findSectors(mesh, test::creasesOf(mesh));
  for (const Sector& s : sectors.list) {
    const int largest = largestIndex(mesh, sectors, sectors.node(mesh, s.first));
    EXPECT_EQ(largest, 1)
        << "two triangles with less than a quarter turn each, or one with less than two";
  }
  const TriMesh fine = test::cube(3).mesh();
  const Sectors many = findSectors(fine, test::creasesOf(fine));
  for (const Sector& s : many.list) {
    const int largest = largestIndex(fine, many, many.node(fine, s.first));
    EXPECT_LE(largest, 2 * s.triangles - 1);
    EXPECT_GE(largest, s.triangles - 1);
  }
}

/// Moves a unit along `steps` edges off Γ, so that there is a vertex with k = 3 and, so far away, one with k = 5.
void addPair(const TriMesh& mesh, AlignedField& field, VertexId from, int steps) {
  PerVertex<char> isPassed(at(mesh.vertexCount()), 0);
  for (VertexId v = from; steps > 0; --steps) {
    isPassed[v] = 1;
    HalfedgeId next;
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      if (!isPassed[mesh.head(h)] && !field.sectors.isOnFeature[mesh.head(h)]) next = h;
    ASSERT_TRUE(next.isValid());
    moveUnit(mesh, next, 1, field);
    v = mesh.head(next);
  }
}

std::vector<int> conesOf(const TriMesh& mesh, const AlignedField& field) {
  std::vector<int> cones;
  for (VertexId v : mesh.vertices())
    if (!field.sectors.isOnFeature[v] && field.index[at(v.i)] != 4) cones.push_back(v.i);
  return cones;
}

TEST(AlignedField, LosesPairsOfConesWhereTheSurfaceIsFlat) {
  const TriMesh mesh = test::annulus(32, 9).mesh();
  const Geometry geometry = computeGeometry(mesh);
  Result<AlignedField> made = fieldOf(mesh, test::creasesOf(mesh));
  ASSERT_TRUE(made);
  ASSERT_TRUE(conesOf(mesh, *made).empty());
  EXPECT_EQ(cancelFlatPairs(mesh, geometry, *made), 0);
  for (const int steps : {1, 2, 5}) {
    AlignedField field = *made;
    addPair(mesh, field, VertexId(32 * 3 + 5), steps);
    addPair(mesh, field, VertexId(32 * 5 + 20), 2);
    ASSERT_EQ(conesOf(mesh, field).size(), 4u);
    AlignedField fewer = field;
    ASSERT_EQ(cancelFlatPairs(mesh, geometry, fewer), 2) << steps;
    fitField(mesh, geometry, fewer);
    EXPECT_TRUE(conesOf(mesh, fewer).empty()) << steps;
    EXPECT_EQ(fewer.moved, field.moved + 2);
    expectLaws("annulus", mesh, fewer);
    expectGaussBonnet("annulus", mesh, fewer);
    // Prescribed indices stay.
    field.given.node = field.index;
    EXPECT_EQ(cancelFlatPairs(mesh, geometry, field), 0);
  }
}

TEST(AlignedField, KeepsConesThatCurvatureExplains) {
  const TriMesh mesh = test::doubleTorus(3).mesh();
  const Geometry geometry = computeGeometry(mesh);
  Result<AlignedField> made = fieldOf(mesh, {});
  ASSERT_TRUE(made);
  const std::vector<int> cones = conesOf(mesh, *made);
  EXPECT_GT(
      std::count_if(cones.begin(), cones.end(), [&](int v) { return made->index[at(v)] < 4; }), 4);
  EXPECT_GT(
      std::count_if(cones.begin(), cones.end(), [&](int v) { return made->index[at(v)] > 4; }), 4);
  EXPECT_EQ(cancelFlatPairs(mesh, geometry, *made), 0);
}

TEST(AlignedField, RefusesATriangleWithThreeFeatureEdges) {
  const TriMesh mesh = test::triangle().mesh();
  const Result<AlignedField> field = fieldOf(mesh, test::creasesOf(mesh));
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().code, ErrorCode::kPrescription);
  EXPECT_EQ(field.error().where.size(), 1u);
}

TEST(AlignedField, GivesADanglingEndOneSector) {
  const TriMesh mesh = test::icosphere(3).mesh();
  const HalfedgeId h(0);
  const std::vector<EdgeId> features{mesh.edge(h)};
  const Result<AlignedField> field = fieldOf(mesh, features);
  ASSERT_TRUE(field);
  ASSERT_EQ(field->sectors.list.size(), 2u);
  for (const Sector& s : field->sectors.list) EXPECT_EQ(s.first, mesh.twin(s.last));
  expectLaws("one edge", mesh, *field);
  expectGaussBonnet("one edge", mesh, *field);
}

}  // namespace
}  // namespace hgp
