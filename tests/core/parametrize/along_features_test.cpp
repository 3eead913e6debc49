// Maps along features.  Laws: certified and exactly straight; cones are those of the field; what does not go together is
// refused with the reason.
#include "hgp/parametrize/along/along_features.h"

#include <gtest/gtest.h>

#include <cmath>

#include "along.h"
#include "hgp/features/field_along.h"
#include "hgp/grid/snap.h"
#include "hgp/optimize/feature_lengths.h"
#include "hgp/parametrize/along/straight_setup.h"
#include "support/creases.h"

namespace hgp {
namespace {

void expectStraight(const std::string& name, const TriMesh& mesh, const Parametrization& run) {
  EXPECT_TRUE(run.isCertified) << name << ": "
                               << (run.certificate.reasons.empty()
                                       ? ""
                                       : run.certificate.reasons[0].message);
  EXPECT_EQ(run.certificate.features.edges, static_cast<int>(run.spec.features.size())) << name;
  EXPECT_EQ(run.certificate.features.straightChains, run.certificate.features.chains) << name;
  test::expectOnLines(name, mesh, run, false);  // once more by hand
}

TEST(AlongFeatures, MapsAreCertifiedAndStraight) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    const Result<Parametrization> run = test::along(shape.mesh, shape.features);
    ASSERT_TRUE(run) << shape.name;
    expectStraight(shape.name, shape.mesh, *run);
  }
}

TEST(AlongFeatures, AnUnknownThatNoRowHoldsIsNoObstacle) {
  // Two rectangles on each other: a translation is in no row of the objective.
  const TriMesh mesh = test::meshOf(
      {{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}, {1, 0, 3}, {1, 3, 2}}});
  const std::vector<EdgeId> rim = test::creasesOf(mesh);
  EXPECT_EQ(rim.size(), 4u);
  const Result<Parametrization> run = test::along(mesh, rim);
  ASSERT_TRUE(run);
  expectStraight("pillow", mesh, *run);
}

TEST(AlongFeatures, StayExactlyStraightInTheNumbersOfEveryFormat) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    const Result<Parametrization> run = test::along(shape.mesh, shape.features);
    ASSERT_TRUE(run) << shape.name;
    std::vector<VertexId> cones;
    for (const ConePoint& cone : run->spec.cones) cones.push_back(cone.vertex);
    const auto snapper = SeamSnapper::make(shape.mesh, run->map, 4, cones, run->spec.features);
    ASSERT_TRUE(snapper) << shape.name;
    for (const StoredNumbers& numbers : {StoredNumbers{}, StoredNumbers{24, true, false}}) {
      UvMap map = run->map;
      const int exponent = gridExponent(map.uv, numbers) + 1;
      const auto snapped = snapper->snap(map.uv, exponent, numbers);
      ASSERT_TRUE(snapped) << shape.name;
      EXPECT_TRUE(snapped->notPositive.empty()) << shape.name;
      map.uv = snapped->uv;
      const Certificate certificate = certify(shape.mesh, run->spec, map);
      EXPECT_TRUE(certificate.isCertified) << shape.name;
      EXPECT_EQ(certificate.exactSeams.exact, static_cast<int>(certificate.seams.seams.size()))
          << shape.name;
      EXPECT_EQ(certificate.features.straightChains, certificate.features.chains) << shape.name;
    }
  }
}

TEST(AlongFeatures, ASquareGridIsMappedToARectangle) {
  const TriMesh mesh = test::jittered(test::grid(9, 6), 0.0).mesh();
  const Result<Parametrization> run = test::along(mesh, test::creasesOf(mesh));
  ASSERT_TRUE(run);
  EXPECT_EQ(run->certificate.features.corners, 4);
  EXPECT_LT(run->certificate.distortion.maxMu, 1e-3);
}

TEST(AlongFeatures, SomeEdgesOfASphereMayDangle) {
  const TriMesh mesh = test::icosphere(5).mesh();
  // Two edges that share a vertex, and one elsewhere.
  const HalfedgeId h(0);
  const std::vector<EdgeId> features{mesh.edge(h), mesh.edge(TriMesh::next(h)),
                                     mesh.edge(HalfedgeId(900))};
  std::vector<EdgeId> sorted = features;
  std::sort(sorted.begin(), sorted.end());
  const Result<Parametrization> run = test::along(mesh, sorted);
  ASSERT_TRUE(run);
  expectStraight("dangling", mesh, *run);
}

TEST(AlongFeatures, RimsAreFeaturesWithAnyOther) {
  const TriMesh mesh = test::cylinder(16, 6).mesh();
  const Result<Parametrization> run = test::along(mesh, {mesh.edge(HalfedgeId(50))});
  ASSERT_TRUE(run);
  EXPECT_GE(run->spec.features.size(), 32u);
  expectStraight("cylinder", mesh, *run);
}

TEST(AlongFeatures, ConesOfTheFieldMayBePrescribedAgain) {
  const TriMesh mesh = test::cube(4).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  const Result<Parametrization> first = test::along(mesh, features);
  ASSERT_TRUE(first);
  PreparedSurface surface(mesh);
  HolonomySpec spec = toSpec(first->spec);
  const Result<Parametrization> again = parametrizeAlongFeatures(surface, spec, {});
  ASSERT_TRUE(again);
  EXPECT_EQ(again->map.uv, first->map.uv);
}

/// A sphere whose only feature is a great circle, through the vertices with z = 0.
std::vector<EdgeId> equatorOf(const TriMesh& mesh) {
  std::vector<EdgeId> edges;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (std::abs(mesh.position(mesh.tail(h))[2]) + std::abs(mesh.position(mesh.head(h))[2]) < 1e-9)
      edges.push_back(e);
  }
  return edges;
}

TEST(AlongFeatures, ConesGoFromOneSideOfAFeatureToTheOther) {
  const TriMesh mesh = test::icosphere(8).mesh();
  const std::vector<EdgeId> features = equatorOf(mesh);
  ASSERT_GE(features.size(), 16u);
  const Result<Parametrization> first = test::along(mesh, features);
  ASSERT_TRUE(first);
  ASSERT_TRUE(first->isCertified);
  PreparedSurface surface(mesh);
  int wrong = 0;
  for (int i = 0; i < 8; ++i) {
    HolonomySpec spec = toSpec(first->spec);
    spec.turning.clear();
    spec.handles.clear();
    const VertexId a((7 + 131 * i) % mesh.vertexCount()), b((400 + 61 * i) % mesh.vertexCount());
    const auto isCone = [&](VertexId v) {
      return std::any_of(spec.cones.begin(), spec.cones.end(),
                         [&](const ConePoint& cone) { return cone.vertex == v; });
    };
    if (isCone(a) || isCone(b)) continue;
    spec.cones.push_back({a, 3});
    spec.cones.push_back({b, 5});
    EXPECT_TRUE(checkAlongFeatures(surface, spec));
    const Result<Parametrization> run = parametrizeAlongFeatures(surface, spec, {});
    ASSERT_TRUE(run) << run.error().message;
    wrong += run->isCertified ? 0 : 1;
    if (run->isCertified) expectStraight("a sphere with an equator", mesh, *run);
    EXPECT_EQ(run->spec.cones.size(), spec.cones.size());
  }
  EXPECT_EQ(wrong, 0);
}

TEST(AlongFeatures, ConesAreRefusedWhereNoneFit) {
  const TriMesh mesh = test::cube(4).mesh();
  HolonomySpec spec = toSpec(test::along(mesh, test::creasesOf(mesh))->spec);
  ASSERT_EQ(spec.cones.size(), 8u);
  PreparedSurface surface(mesh);
  spec.cones[0].k = 2;  // between three edges
  spec.cones[1].k = 4;
  for (const Status& other : {checkAlongFeatures(surface, spec),
                              Status(parametrizeAlongFeatures(surface, spec, {}).error())}) {
    ASSERT_FALSE(other);
    EXPECT_EQ(other.error().code, ErrorCode::kPrescription);
    EXPECT_FALSE(other.error().where.empty());
  }
}

/// A rim without corners but those that are given.
HolonomySpec rimOf(const TriMesh& mesh, std::vector<ConePoint> corners,
                   std::vector<ConePoint> cones = {}) {
  HolonomySpec spec;
  spec.features = test::creasesOf(mesh);
  spec.corners = std::move(corners);
  spec.cones = std::move(cones);
  return spec;
}

TEST(AlongFeatures, CornersOfARimAreThoseThatAreGiven) {
  const TriMesh mesh = test::jittered(test::grid(9, 6), 0.0).mesh();
  const Topology topology = computeTopology(mesh);
  const auto& rim = topology.loops[0].halfedges;
  // Corners of the grid may be straight in the map: they have two triangles or get them by a split, which is not done here.
  std::vector<ConePoint> corners;
  for (std::size_t i = 0; i < rim.size(); ++i)
    if (mesh.valence(mesh.tail(rim[i])) == 1) corners.push_back({mesh.tail(rim[i]), 1});
  ASSERT_EQ(corners.size(), 2u);
  for (const std::size_t step : {std::size_t{4}, std::size_t{9}})
    for (std::size_t i = step; corners.size() < 4; i += step)
      if (mesh.valence(mesh.tail(rim[i])) > 2) corners.push_back({mesh.tail(rim[i]), 1});
  PreparedSurface surface(mesh);
  const Result<Parametrization> run = parametrizeAlongFeatures(surface, rimOf(mesh, corners), {});
  ASSERT_TRUE(run);
  expectStraight("four corners", mesh, *run);
  EXPECT_EQ(run->certificate.features.corners, 4);
  EXPECT_TRUE(run->spec.cones.empty());
}

TEST(AlongFeatures, ConesOffFeaturesAreKeptAndCornersMakeUpTheRest) {
  const TriMesh mesh = test::jittered(test::grid(12, 9), 0.0).mesh();
  for (const int k : {3, 5}) {
    const VertexId inside(4 * 13 + 6);
    ASSERT_FALSE(mesh.isBoundary(inside));
    PreparedSurface surface(mesh);
    const Result<Parametrization> run =
        parametrizeAlongFeatures(surface, rimOf(mesh, {}, {{inside, k}}), {});
    ASSERT_TRUE(run) << k;
    expectStraight("one cone", mesh, *run);
    ASSERT_EQ(run->spec.cones.size(), 1u);
    EXPECT_EQ(run->spec.cones[0].vertex, inside);
    EXPECT_EQ(run->spec.cones[0].k, k);
    EXPECT_EQ(run->spec.turning, std::vector<int>{k});  // 4 − (4 − k)
  }
}

TEST(AlongFeatures, WhatDoesNotAddUpIsRefusedWithItsPlaces) {
  const TriMesh mesh = test::jittered(test::grid(9, 6), 0.0).mesh();
  const VertexId corner(0);
  PreparedSurface surface(mesh);
  for (const int k : {1, 20}) {  // one corner alone; and more than its triangles hold
    const Result<Parametrization> run =
        parametrizeAlongFeatures(surface, rimOf(mesh, {{corner, k}}), {});
    ASSERT_FALSE(run) << k;
    EXPECT_EQ(run.error().code, ErrorCode::kPrescription);
    EXPECT_FALSE(run.error().where.empty());
  }
}

TEST(AlongFeatures, RefusesWhatDoesNotGoTogether) {
  const TriMesh mesh = test::cube(3).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  ParametrizeOptions frames;
  frames.frames.emplace();
  const Result<Parametrization> run = test::along(mesh, features, frames);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::kUsage);
  PreparedSurface surface(mesh);
  HolonomySpec spec;
  spec.q = 6;
  spec.features = features;
  EXPECT_EQ(parametrizeAlongFeatures(surface, spec, {}).error().code, ErrorCode::kUsage);
}

/// A cylinder whose lower rim climbs slowly all around and falls back within one edge, while the upper one is straight.
TriMesh steppedCylinder(int m, int n, double fall) {
  MeshData data = test::cylinder(m, n).data;
  double top = 0.0;
  for (const Vec3& p : data.positions) top = std::max(top, p[2]);
  for (Vec3& p : data.positions) {
    const double around = 0.5 + std::atan2(p[1], p[0]) / (2.0 * kPi);  // from 0 to 1
    const double low = fall * (around < 1.0 - 0.5 / m ? around : 0.0);
    p[2] = low + (top - low) * p[2] / top;
  }
  return test::meshOf(data);
}

LengthFit lengthsOf(const TriMesh& mesh, const std::vector<EdgeId>& features) {
  PreparedSurface surface(mesh);
  std::vector<StageTime> times;
  const Result<StraightSetup> setup = prepareStraight(surface, features, HolonomySpec{}, {}, times);
  EXPECT_TRUE(setup);
  const SeamlessSystem system = systemOf(mesh, setup->seamless);
  return fitLengths(straightSystemOf(*setup, system));
}

TEST(AlongFeatures, LengthsArePossibleWhereThereIsAMap) {
  for (const test::CreasedShape& shape : test::creasedShapes()) {
    const LengthFit fit = lengthsOf(shape.mesh, shape.features);
    EXPECT_TRUE(fit.isPossible) << shape.name;
    EXPECT_LT(fit.excess, 1e-3) << shape.name;
    EXPECT_TRUE(fit.edges.empty() && fit.flat.empty()) << shape.name;
  }
}

TEST(AlongFeatures, WithoutUnknownsNoEdgeHasALength) {
  const TriMesh mesh = test::cube(3).mesh();
  const std::vector<EdgeId> features = test::creasesOf(mesh);
  PreparedSurface surface(mesh);
  std::vector<StageTime> times;
  Result<StraightSetup> setup = prepareStraight(surface, features, HolonomySpec{}, {}, times);
  ASSERT_TRUE(setup);
  setup->distances.clear();
  setup->unknowns.count = 0;
  setup->unknowns.variable.clear();
  setup->unknowns.rows = RealUnknowns::Rows(setup->unknowns.rows.rows(), 0);
  const SeamlessSystem system = systemOf(mesh, setup->seamless);
  const LengthFit fit = fitLengths(straightSystemOf(*setup, system));
  EXPECT_FALSE(fit.isPossible);
  EXPECT_EQ(fit.edges.size(), features.size());
  EXPECT_EQ(fit.flat.size(), at(mesh.faceCount()));
  EXPECT_EQ(fit.excess, static_cast<double>(features.size() + fit.flat.size()));
}

TEST(AlongFeatures, AStepThatCanHaveNoLengthIsStraightenedAndSaid) {
  const TriMesh mesh = steppedCylinder(48, 8, 0.7);
  const std::vector<EdgeId> rims = test::creasesOf(mesh);
  // The field has the step: two corners on the lower rim and none on the upper one.
  const Result<AlignedField> field = alignedField(mesh, prepareSurface(mesh), rims);
  ASSERT_TRUE(field);
  int corners = 0;
  for (const Sector& s : field->sectors.list)
    corners += field->index[at(field->sectors.node(mesh, s.first))] != 2;
  EXPECT_EQ(corners, 2);
  // Lengths alone show it: the edges of the step have none.
  EXPECT_FALSE(lengthsOf(mesh, rims).isPossible);
  EXPECT_GT(lengthsOf(mesh, rims).excess, 0.5);
  for (HalfedgeId h : lengthsOf(mesh, rims).edges)
    EXPECT_NE(mesh.position(mesh.tail(h))[2], mesh.position(mesh.head(h))[2]);
  const Result<Parametrization> run = test::along(mesh, rims);
  ASSERT_TRUE(run);
  expectStraight("stepped cylinder", mesh, *run);
  EXPECT_EQ(run->certificate.features.corners, 0);
  ASSERT_FALSE(run->notes.empty());
  EXPECT_EQ(run->notes.back(), Note("features-straightened", {{"steps", 1}}));
  EXPECT_EQ(run->rounds.size(), 1U) << "no program is solved for the field with the step";
}

/// A cube whose vertices are moved at random, each coordinate by up to `size` / 2 of an edge.
TriMesh shakenCube(int n, unsigned seed, double size) {
  MeshData data = test::cube(n).data;
  for (Vec3& p : data.positions)
    for (double& x : p) {
      seed = seed * 1664525U + 1013904223U;
      x += size / n * ((seed >> 8) / 16777216.0 - 0.5);
    }
  return test::meshOf(data);
}

TEST(AlongFeatures, RoundsThatDoNotSufficeLeaveNoMapAndAreNoCancellation) {
  const TriMesh mesh = shakenCube(3, 15851, 0.6);
  HolonomySpec spec;
  spec.features = test::creasesOf(test::cube(3).mesh());
  int rounds = 1;
  for (bool isCertified = false; !isCertified && rounds < 12; ++rounds) {
    PreparedSurface surface(mesh);
    ParametrizeOptions options;
    options.maxRounds = rounds;
    const Result<Parametrization> run = parametrizeAlongFeatures(surface, spec, options);
    ASSERT_TRUE(run) << rounds;
    EXPECT_LE(static_cast<int>(run->rounds.size()), rounds);
    isCertified = run->isCertified;
  }
  EXPECT_GT(rounds, 2) << "one round is not enough where frames contradict each other";
  EXPECT_LT(rounds, 12);
}

TEST(AlongFeatures, CornersMoveWhereTheirLengthsContradictEachOther) {
  // Prisms: where an angle lies between 90° and 180°, corners of both caps are chosen almost freely, and
  // sides of one cap that are as long as others together meet such of the other cap.
  for (int n = 4; n <= 16; n += 2) {
    MeshData data;
    for (const double z : {0.0, 2.0})
      for (int i = 0; i < n; ++i)
        data.positions.push_back({std::cos(2.0 * kPi * i / n), std::sin(2.0 * kPi * i / n), z});
    for (int i = 0; i < n; ++i) {
      const int j = (i + 1) % n;
      data.triangles.push_back({i, j, n + j});
      data.triangles.push_back({i, n + j, n + i});
    }
    // Each cap gets a ring around its middle, so that no edge joins two vertices of one side.
    for (const int cap : {0, 1}) {
      const int ring = static_cast<int>(data.positions.size());
      for (int i = 0; i < n; ++i)
        data.positions.push_back(
            {0.5 * std::cos(2.0 * kPi * i / n), 0.5 * std::sin(2.0 * kPi * i / n), 2.0 * cap});
      data.positions.push_back({0.0, 0.0, 2.0 * cap});
      const auto add = [&](int a, int b, int c) {
        data.triangles.push_back(cap == 1 ? std::array{a, b, c} : std::array{a, c, b});
      };
      for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n, base = cap * n;
        add(base + i, base + j, ring + j);
        add(base + i, ring + j, ring + i);
        add(ring + i, ring + j, ring + n);
      }
    }
    const TriMesh mesh = test::meshOf(data);
    const std::vector<EdgeId> creases = test::creasesOf(mesh);
    const Result<Parametrization> run = test::along(mesh, creases);
    ASSERT_TRUE(run) << n;
    expectStraight("prism of " + std::to_string(n) + " sides", mesh, *run);
  }
}

TEST(AlongFeatures, CheckRefusesWhatTheSolveRefuses) {
  const TriMesh mesh = test::cube(4).mesh();
  PreparedSurface surface(mesh);
  HolonomySpec spec;
  spec.features = test::creasesOf(mesh);
  EXPECT_TRUE(checkAlongFeatures(surface, spec));
  spec.q = 2;
  EXPECT_EQ(checkAlongFeatures(surface, spec).error().code, ErrorCode::kUsage);
  const TriMesh one = test::triangle().mesh();
  PreparedSurface small(one);
  spec.q = 4;
  spec.features = test::creasesOf(one);
  EXPECT_EQ(checkAlongFeatures(small, spec).error().code, ErrorCode::kPrescription);
}

TEST(AlongFeatures, IsCancelled) {
  const TriMesh mesh = test::cube(4).mesh();
  ParametrizeOptions options;
  options.progress = [](const ProgressReport& r) { return r.stage != Stage::kSolve; };
  const Result<Parametrization> run = test::along(mesh, test::creasesOf(mesh), options);
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().code, ErrorCode::kCancelled);
}

}  // namespace
}  // namespace hgp
