// Frames of a field that somebody else computed, and what is refused of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/field/prescribed_field.h"
#include "hgp/parametrize/parametrize.h"
#include "support/fields.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// A surface with a prescription, and the field that our own solver takes for it.
struct Problem {
  std::string name;
  TriMesh mesh;
  PrescribedField own;
};

/// Fields that turn by less than half a turn across every edge: their directions tell all.
std::vector<Problem> problems(const std::vector<int>& orders = {3, 4, 6}) {
  std::mt19937 random(41);
  std::vector<Problem> out;
  for (const test::Shape& shape : {test::icosphere(5), test::pretzel(1, 2), test::doubleTorus(2),
                                   test::annulus(16, 5), test::puncturedTorus(12, 10)}) {
    TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    for (int q : orders) {
      const auto spec = test::randomSpec(mesh, context->topology, {q, 8, false, false}, random);
      if (!spec) continue;
      Result<PrescribedField> own = prescribedField(mesh, *context, *spec);
      if (!own || own->largestTurn > 3.0) continue;
      out.push_back({shape.name + " q=" + std::to_string(q), mesh, std::move(*own)});
    }
  }
  return out;
}

ParametrizeOptions withFrames(FieldData data) {
  ParametrizeOptions options;
  options.frames = std::move(data);
  return options;
}

Complex uvOf(const Parametrization& p, std::size_t i) {
  return {p.map.uv[i][0] - p.map.uv[0][0], p.map.uv[i][1] - p.map.uv[0][1]};
}

/// Largest |b − e^{iα} a| over the vertices, relative to the extent; both seen from vertex 0.
double distance(const Parametrization& a, const Parametrization& b, double turned = 0.0) {
  double largest = 0.0, extent = 0.0;
  for (std::size_t i = 0; i < a.map.uv.size(); ++i) {
    largest = std::max(largest, std::abs(uvOf(b, i) - std::polar(1.0, turned) * uvOf(a, i)));
    extent = std::max(extent, std::abs(uvOf(a, i)));
  }
  return largest / extent;
}

/// The rotation from a to b. Without given frames a map is turned as the surface lies; with them, as they say.
double turnBetween(const Parametrization& a, const Parametrization& b) {
  Complex sum = 0.0;
  for (std::size_t i = 0; i < a.map.uv.size(); ++i) sum += std::conj(uvOf(a, i)) * uvOf(b, i);
  return std::arg(sum);
}

TEST(GivenFrames, TheSolversOwnFieldFedBackGivesTheSameMapUpToARotation) {
  int count = 0;
  for (const Problem& one : problems({3, 4, 6, 3, 4, 6})) {
    SCOPED_TRACE(one.name);
    const Result<Parametrization> own = parametrize(one.mesh, toSpec(one.own.spec), {});
    ASSERT_TRUE(own) << own.error().message;
    // Frames of an angle structure are in no file: given frames leave that round out.
    const auto isByAngles = [](const Round& round) {
      return round.method == "harmonic, frames of angles";
    };
    if (std::any_of(own->rounds.begin(), own->rounds.end(), isByAngles)) continue;
    for (int sign : {1, -1}) {
      const Result<Parametrization> p = parametrize(
          one.mesh, toSpec(one.own.spec), withFrames(test::dataOf(one.mesh, one.own.field, sign)));
      ASSERT_TRUE(p) << p.error().message;
      EXPECT_EQ(p->isCertified, own->isCertified);
      ASSERT_EQ(p->rounds.size(), own->rounds.size());
      ASSERT_EQ(p->map.uv.size(), own->map.uv.size());
      if (own->isCertified) {
        EXPECT_LT(distance(*own, *p, turnBetween(*own, *p)), 1e-6);
      }
    }
    count += own->isCertified;
  }
  EXPECT_GT(count, 7);
}

TEST(GivenFrames, DirectionsTurnedByAConstantAngleTurnTheMapBack) {
  const double angle = 0.4;
  int count = 0;
  for (Problem& one : problems({3, 4, 6, 3, 4, 6})) {
    SCOPED_TRACE(one.name);
    const Result<Parametrization> own = parametrize(
        one.mesh, toSpec(one.own.spec), withFrames(test::dataOf(one.mesh, one.own.field)));
    ASSERT_TRUE(own);
    for (double& a : one.own.field.angle.raw()) a += angle;
    const Result<Parametrization> p = parametrize(
        one.mesh, toSpec(one.own.spec), withFrames(test::dataOf(one.mesh, one.own.field)));
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->isCertified, own->isCertified);
    if (!own->isCertified) continue;
    EXPECT_LT(distance(*own, *p, -angle), 1e-6);
    ++count;
  }
  EXPECT_GT(count, 7);
}

TEST(GivenFrames, WhatThePrescriptionLeavesOpenIsTheFields) {
  for (const Problem& one : problems()) {
    SCOPED_TRACE(one.name);
    HolonomySpec cones;
    cones.q = one.own.spec.q;
    cones.cones = one.own.spec.cones;
    const Result<Parametrization> p =
        parametrize(one.mesh, cones, withFrames(test::dataOf(one.mesh, one.own.field)));
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_EQ(p->spec.turning, one.own.spec.turning);
    EXPECT_EQ(p->spec.handles, one.own.spec.handles);
  }
}

void expectRefused(const Problem& one, const HolonomySpec& spec, FieldData data, ErrorCode code,
                   const std::string& word) {
  SCOPED_TRACE(one.name + ": " + word);
  const Result<Parametrization> p = parametrize(one.mesh, spec, withFrames(std::move(data)));
  ASSERT_FALSE(p);
  EXPECT_EQ(p.error().code, code);
  EXPECT_NE(p.error().message.find(word), std::string::npos) << p.error().message;
}

TEST(GivenFrames, AFieldThatContradictsTheConesIsRefusedWithTheVertices) {
  for (const Problem& one : problems()) {
    FieldData data = test::dataOf(one.mesh, one.own.field);
    HolonomySpec moved = toSpec(one.own.spec);
    moved.cones[0].vertex = one.mesh.head(one.mesh.outgoing(moved.cones[0].vertex));
    if (one.mesh.isBoundary(moved.cones[0].vertex)) continue;
    expectRefused(one, moved, data, ErrorCode::kPrescription, "contradict the cones at");
    data.hasMatchings = false;  // the directions alone have cones of their own
    const Result<Parametrization> p = parametrize(one.mesh, moved, withFrames(data));
    ASSERT_FALSE(p) << one.name;
    EXPECT_EQ(p.error().code, ErrorCode::kPrescription) << p.error().message;
    ASSERT_FALSE(p.error().where.empty());
    EXPECT_EQ(p.error().where[0].kind, Where::Kind::kVertex);
  }
}

TEST(GivenFrames, AFieldThatContradictsTurningOrHandlesIsRefused) {
  int turnings = 0, handles = 0;
  for (const Problem& one : problems()) {
    const FieldData data = test::dataOf(one.mesh, one.own.field);
    HolonomySpec spec = toSpec(one.own.spec);
    if (spec.turning.size() > 1) {
      *spec.turning[0] += 1;
      *spec.turning[1] -= 1;
      expectRefused(one, spec, data, ErrorCode::kPrescription, "boundary loop");
      ++turnings;
    }
    spec = toSpec(one.own.spec);
    if (!spec.handles.empty()) {
      *spec.handles[1] += 1;
      expectRefused(one, spec, data, ErrorCode::kPrescription, "handle generator 1");
      ++handles;
    }
  }
  EXPECT_GT(turnings, 0);
  EXPECT_GT(handles, 0);
}

TEST(GivenFrames, WhatIsNoDirectionOnEveryTriangleIsRefused) {
  const Problem one = std::move(problems().front());
  const HolonomySpec spec = toSpec(one.own.spec);
  const FieldData data = test::dataOf(one.mesh, one.own.field);
  FieldData wrong = data;
  wrong.directions.pop_back();
  expectRefused(one, spec, wrong, ErrorCode::kMalformed, "faces");
  wrong.directions.clear();
  expectRefused(one, spec, wrong, ErrorCode::kUsage, "no directions");
  wrong = data;
  wrong.order = spec.q + 1;
  expectRefused(one, spec, wrong, ErrorCode::kPrescription, "order");
  const double nan = std::nan("");
  for (const Vec3& bad : {Vec3{nan, 0, 0}, Vec3{0, 0, 0}, Vec3{HUGE_VAL, 0, 0}}) {
    wrong = data;
    wrong.directions[7] = bad;
    expectRefused(one, spec, wrong, ErrorCode::kMalformed, "direction");
    const Result<Parametrization> p = parametrize(one.mesh, spec, withFrames(wrong));
    ASSERT_EQ(p.error().where.size(), 1U);
    EXPECT_EQ(p.error().where[0].id, 7);
  }
}

TEST(GivenFrames, ConvexBoundariesTakeNone) {
  const TriMesh mesh = test::disk(4).mesh();
  FieldData data;
  data.directions.assign(static_cast<std::size_t>(mesh.faceCount()), Vec3{1, 0, 0});
  const Result<Parametrization> convex = parametrizeConvex(mesh, withFrames(data));
  ASSERT_FALSE(convex);
  EXPECT_EQ(convex.error().code, ErrorCode::kUsage);
}

TEST(GivenFrames, AMapThatTheyDoNotCertifySaysSoAndAdvisesAutomaticOnes) {
  Problem one = std::move(problems()[1]);
  // Every other frame is turned by almost a right angle: no map turns neighbours so. Around a vertex
  // the turns cancel as long as none exceeds half a turn, so that the cones stay.
  for (FaceId f : one.mesh.faces()) one.own.field.angle[f] += f.i % 2 == 0 ? 1.3 : 0.0;
  const FieldData data = test::dataOf(one.mesh, one.own.field);
  ParametrizeOptions options = withFrames(data);
  options.maxRounds = 1;
  const Result<Parametrization> p = parametrize(one.mesh, toSpec(one.own.spec), options);
  ASSERT_TRUE(p) << p.error().message;
  EXPECT_FALSE(p->isCertified);
  ASSERT_FALSE(p->notes.empty());
  EXPECT_EQ(p->notes.back().code, "map-given-frames");
}

}  // namespace
}  // namespace hgp
