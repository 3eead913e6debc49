#include "hgp/field/read_holonomy.h"

#include <gtest/gtest.h>

#include "support/fields.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

bool sameCones(const std::vector<ConePoint>& a, const std::vector<ConePoint>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.vertex == y.vertex && x.k == y.k;
  });
}

void expectSame(const CompleteSpec& read, const CompleteSpec& asked) {
  EXPECT_EQ(read.q, asked.q);
  EXPECT_TRUE(sameCones(read.cones, asked.cones));
  EXPECT_EQ(read.handles, asked.handles);
  ASSERT_EQ(read.turning.size(), asked.turning.size());
  long long difference = 0;  // the lift of each loop is free as long as Lemma 6.2 balances
  for (std::size_t j = 0; j < read.turning.size(); ++j) {
    EXPECT_EQ(reduceTurn(read.turning[j], asked.q), reduceTurn(asked.turning[j], asked.q));
    difference += read.turning[j] - asked.turning[j];
  }
  EXPECT_EQ(difference, 0);
}

/// k that a reflection changes somewhere, so that the sign of the matchings can be told.
bool isChiral(const CompleteSpec& spec) {
  for (const ConePoint& cone : spec.cones)
    if (reduceTurn(2 * cone.k, spec.q) != 0) return true;
  return false;
}

template <class Law>
int forRandomFields(const Law& law) {
  std::mt19937 random(23);
  int count = 0;
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    EXPECT_TRUE(context) << shape.name;
    for (int q : {1, 2, 3, 4, 5, 6, 7, 8}) {
      const auto spec = test::randomSpec(mesh, context->topology, {q, 5, true, false}, random);
      if (!spec) continue;
      const Result<PrescribedField> field = prescribedField(mesh, *context, *spec);
      if (!field) continue;
      SCOPED_TRACE(shape.name + " q=" + std::to_string(q));
      law(mesh, *context, *field);
      ++count;
    }
  }
  return count;
}

TEST(ReadHolonomy, MatchingsGiveBackThePrescriptionWithEitherSign) {
  int chiral = 0;
  const int count = forRandomFields(
      [&](const TriMesh& mesh, const FieldContext& context, const PrescribedField& made) {
        if (made.spec.cones.empty()) return;
        for (int sign : {1, -1}) {
          if (sign < 0 && !isChiral(made.spec)) continue;
          chiral += sign < 0;
          const Result<CompleteSpec> read = specOfFieldData(
              mesh, context, test::matchingsOf(mesh, made.field, sign), made.spec.cones);
          ASSERT_TRUE(read) << read.error().message;
          expectSame(*read, made.spec);
        }
      });
  EXPECT_GT(count, 60);
  EXPECT_GT(chiral, 40);
}

TEST(ReadHolonomy, DirectionsDetermineTheLiftOfStoredMatchings) {
  int count = 0;
  forRandomFields(
      [&](const TriMesh& mesh, const FieldContext& context, const PrescribedField& made) {
        if (made.largestTurn > 3.0 || !isChiral(made.spec)) return;
        FieldData data = test::matchingsOf(mesh, made.field, 1);
        data.directions = test::directionsOf(mesh, made.field);
        const Result<CompleteSpec> read = specOfFieldData(mesh, context, data);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(sameCones(read->cones, made.spec.cones));
        EXPECT_EQ(read->handles, made.spec.handles);
        EXPECT_EQ(read->turning, made.spec.turning);
        ++count;
      });
  EXPECT_GT(count, 20);
}

TEST(ReadHolonomy, DirectionsAloneGiveThePrescriptionWhereTheyTurnByLessThanHalfAStep) {
  int count = 0;
  forRandomFields(
      [&](const TriMesh& mesh, const FieldContext& context, const PrescribedField& made) {
        if (made.largestTurn > 0.95 * kPi / made.spec.q) return;
        FieldData data;
        data.order = made.spec.q;
        data.directions = test::directionsOf(mesh, made.field);
        const Result<CompleteSpec> read = specOfFieldData(mesh, context, data);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_TRUE(sameCones(read->cones, made.spec.cones));
        EXPECT_EQ(read->handles, made.spec.handles);
        EXPECT_EQ(read->turning, made.spec.turning);
        ++count;
      });
  EXPECT_GT(count, 10);
}

TEST(ReadHolonomy, AnyFieldBalancesLemma62) {
  std::mt19937 random(29);
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    for (int q : {1, 2, 4, 5}) {
      FrameField field;
      field.q = q;
      field.angle = PerFace<double>(static_cast<std::size_t>(mesh.faceCount()));
      for (FaceId f : mesh.faces()) field.angle[f] = kPi * test::randomReal(random);
      matchPrincipally(mesh, context->geometry, field);
      const CompleteSpec spec = specOfField(mesh, *context, field);
      long long sum = 0;
      for (const ConePoint& cone : spec.cones) sum += q - cone.k;
      for (int l : spec.turning) sum += l;
      EXPECT_EQ(sum, q * shape.eulerCharacteristic()) << shape.name << " q=" << q;
    }
  }
}

TEST(ReadHolonomy, ConesThatContradictTheMatchingsAreRefused) {
  const TriMesh mesh = test::icosphere(3).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  std::mt19937 random(31);
  const auto spec = test::randomSpec(mesh, context->topology, {4, 6, true, false}, random);
  ASSERT_TRUE(spec);
  const Result<PrescribedField> made = prescribedField(mesh, *context, *spec);
  ASSERT_TRUE(made);
  std::vector<ConePoint> moved = made->spec.cones;
  moved[0].vertex = mesh.head(mesh.outgoing(moved[0].vertex));
  const Result<CompleteSpec> read =
      specOfFieldData(mesh, *context, test::matchingsOf(mesh, made->field, 1), moved);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::kPrescription);
}

TEST(ReadHolonomy, DataThatDoesNotFitTheMeshIsMalformed) {
  const TriMesh mesh = test::icosphere(1).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  FieldData nothing;
  FieldData tooFew;
  tooFew.directions.resize(3);
  FieldData noFace;
  noFace.hasMatchings = true;
  noFace.matchings.push_back({99, 0, 0, 1, 1});
  FieldData noEdge = noFace;
  noEdge.matchings[0] = {0, 1, 7, 7, 1};
  FieldData wrongNeighbour = noFace;
  const HalfedgeId h(0);
  wrongNeighbour.matchings[0] = {0, (TriMesh::face(mesh.twin(h)).i + 1) % 20, mesh.tail(h).i,
                                 mesh.head(h).i, 1};
  for (const FieldData& data : {nothing, tooFew, noFace, noEdge, wrongNeighbour}) {
    const Result<CompleteSpec> read = specOfFieldData(mesh, *context, data);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed) << read.error().message;
  }
}

TEST(ReadHolonomy, WithoutConesTheSignIsTheOneCloserToTransport) {
  // Handle rotations of a cone-free surface look alike with either sign; directions tell.
  const TriMesh mesh = test::puncturedTorus(12, 10).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  HolonomySpec spec;
  spec.handles = {1, 0};
  const Result<PrescribedField> made = prescribedField(mesh, *context, spec);
  ASSERT_TRUE(made) << made.error().message;
  ASSERT_TRUE(made->spec.cones.empty());
  ASSERT_LT(made->largestTurn, 3.0);
  for (int sign : {1, -1}) {
    const Result<CompleteSpec> read =
        specOfFieldData(mesh, *context, test::dataOf(mesh, made->field, sign));
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_TRUE(read->cones.empty());
    EXPECT_EQ(read->handles, made->spec.handles) << sign;
  }
}

TEST(ReadHolonomy, DirectionsDetermineTheTurningOfLoopsAlsoWithGivenCones) {
  int count = 0;
  forRandomFields(
      [&](const TriMesh& mesh, const FieldContext& context, const PrescribedField& made) {
        if (made.largestTurn > 3.0 || made.spec.turning.size() < 2) return;
        const Result<CompleteSpec> read =
            specOfFieldData(mesh, context, test::dataOf(mesh, made.field), made.spec.cones);
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(read->turning, made.spec.turning);
        ++count;
      });
  EXPECT_GT(count, 5);
}

TEST(ReadHolonomy, ATriangleWithoutDirectionIsMalformedAndNamed) {
  const TriMesh mesh = test::grid(3, 3).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  FieldData data;
  data.directions.assign(static_cast<std::size_t>(mesh.faceCount()), Vec3{1, 0, 0});
  EXPECT_TRUE(specOfFieldData(mesh, *context, data));
  for (const Vec3& bad : {Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{0, std::nan(""), 0}}) {
    data.directions[5] = bad;
    const Result<CompleteSpec> read = specOfFieldData(mesh, *context, data);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kMalformed);
    ASSERT_EQ(read.error().where.size(), 1U);
    EXPECT_EQ(read.error().where[0].id, 5);
  }
}

}  // namespace
}  // namespace hgp
