#include "hgp/field/prescribed_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <tuple>

#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// ω across h from face(h) to its twin's: what the field turns beyond Levi-Civita transport.
double adjustment(const TriMesh& mesh, const Geometry& geometry, const FrameField& field,
                  HalfedgeId h) {
  const HalfedgeId own = mesh.halfedge(mesh.edge(h));
  const FaceId f = TriMesh::face(own), g = TriMesh::face(mesh.twin(own));
  const double turned = field.angle[g] + turnAngle(field.matching[own], field.q) - field.angle[f] -
                        transport(mesh, geometry, own);
  return own == h ? turned : -turned;
}

/// Every shape with random cones and handles for q = 1 … 8, small enough to be quick.
template <class Law>
void forAllFields(const Law& law) {
  std::mt19937 random(17);
  int laws = 0;
  for (const test::Shape& shape : test::all()) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context) << shape.name;
    for (int q = 1; q <= 8; ++q) {
      for (int cones : {0, 1, 4, 7}) {
        const auto spec = test::randomSpec(mesh, context->topology,
                                           {q, cones, (q + cones) % 2 == 0, q % 3 == 0}, random);
        if (!spec) continue;
        const Result<PrescribedField> field = prescribedField(mesh, *context, *spec);
        if (!field) {  // no admissible turning: allowed where few triangles meet a loop
          EXPECT_EQ(field.error().code, ErrorCode::kPrescription);
          EXPECT_FALSE(context->topology.loops.empty());
          continue;
        }
        SCOPED_TRACE(shape.name + " q=" + std::to_string(q) + " cones=" + std::to_string(cones));
        ++laws;
        law(mesh, *context, *spec, *field);
      }
    }
  }
  EXPECT_GT(laws, 250);
}

PerVertex<int> askedIndices(const TriMesh& mesh, const CompleteSpec& spec) {
  PerVertex<int> k(static_cast<std::size_t>(mesh.vertexCount()), spec.q);
  for (const ConePoint& cone : spec.cones) k[cone.vertex] = cone.k;
  return k;
}

TEST(TrivialConnection, AroundEveryVertexItTurnsByTheAskedMinusTheOwnCurvature) {
  forAllFields([](const TriMesh& mesh, const FieldContext& context, const HolonomySpec&,
                  const PrescribedField& result) {
    const PerVertex<int> k = askedIndices(mesh, result.spec);
    std::vector<double> sum(static_cast<std::size_t>(context.surface.nodeCount), 0.0);
    for (VertexId v : mesh.vertices())
      for (HalfedgeId h : outgoingHalfedges(mesh, v))
        if (!mesh.isBoundary(h))  // counterclockwise around the node: from the right to the left
          sum[static_cast<std::size_t>(context.surface.node[v])] +=
              adjustment(mesh, context.geometry, result.field, mesh.twin(h));
    for (VertexId v : mesh.vertices()) {
      if (mesh.isBoundary(v)) continue;
      const auto node = static_cast<std::size_t>(context.surface.node[v]);
      EXPECT_NEAR(sum[node], coneCurvature(k[v], result.spec.q) - context.surface.curvature[node],
                  1e-8);
    }
    for (std::size_t j = 0; j < context.surface.loopNode.size(); ++j) {
      const auto node = static_cast<std::size_t>(context.surface.loopNode[j]);
      EXPECT_NEAR(
          sum[node],
          coneCurvature(-result.spec.turning[j], result.spec.q) - context.surface.curvature[node],
          1e-8);
    }
  });
}

TEST(TrivialConnection, MatchingsAreIntegersThatSumToKAroundVerticesAndToLAroundLoops) {
  forAllFields([](const TriMesh& mesh, const FieldContext& context, const HolonomySpec&,
                  const PrescribedField& result) {
    const FrameField& field = result.field;
    for (HalfedgeId h : mesh.halfedges())
      EXPECT_EQ(field.matching[h], mesh.isBoundary(h) ? 0 : -field.matching[mesh.twin(h)]);
    const PerVertex<int> k = askedIndices(mesh, result.spec);
    const auto counterclockwise = [&](VertexId v) {
      long long sum = 0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v)) sum -= field.matching[h];
      return sum;
    };
    for (VertexId v : mesh.vertices())
      if (!mesh.isBoundary(v)) {
        EXPECT_EQ(reduceTurn(counterclockwise(v), field.q), reduceTurn(-k[v], field.q));
      }
    for (std::size_t j = 0; j < context.topology.loops.size(); ++j) {
      long long sum = 0;
      for (HalfedgeId h : context.topology.loops[j].halfedges)
        sum += counterclockwise(mesh.tail(h));
      EXPECT_EQ(reduceTurn(sum, field.q), reduceTurn(result.spec.turning[j], field.q));
    }
  });
}

TEST(TrivialConnection, HolonomyAlongEveryGeneratorIsAsPrescribed) {
  forAllFields([](const TriMesh&, const FieldContext& context, const HolonomySpec& asked,
                  const PrescribedField& result) {
    ASSERT_EQ(result.spec.handles.size(), context.handles.loops.size());
    for (std::size_t i = 0; i < context.handles.loops.size(); ++i) {
      EXPECT_EQ(loopHolonomy(result.field, context.handles.loops[i]), result.spec.handles[i]);
      if (i < asked.handles.size()) {
        EXPECT_EQ(result.spec.handles[i], reduceTurn(*asked.handles[i], asked.q));
      }
    }
  });
}

TEST(TrivialConnection, OpenLoopsOfAFlatDomainTurnAsTheyDoInThePlane) {
  // Without cones u = 0 everywhere is the metric that open loops are read from: the outer loop turns
  // by one turn, every hole by one turn backwards, however large it is.
  for (const std::vector<int>& holes : {std::vector<int>{22}, {22, 32, 64}, {22, 32, 56, 64}}) {
    const TriMesh mesh = test::withoutFaces(test::grid(9, 5), holes).mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    ASSERT_EQ(context->topology.loops.size(), holes.size() + 1);
    for (int q : {1, 3, 4}) {
      HolonomySpec spec;
      spec.q = q;
      const Result<PrescribedField> field = prescribedField(mesh, *context, spec);
      ASSERT_TRUE(field) << field.error().message;
      for (std::size_t j = 0; j < context->topology.loops.size(); ++j) {
        const bool isOuter = context->topology.loops[j].halfedges.size() > 3;
        EXPECT_EQ(field->spec.turning[j], isOuter ? q : -q) << "q = " << q << ", loop " << j;
      }
    }
  }
}

TEST(TrivialConnection, CompletedTurningBalancesLemma62AndKeepsWhatWasGiven) {
  forAllFields([](const TriMesh& mesh, const FieldContext& context, const HolonomySpec& asked,
                  const PrescribedField& result) {
    const CompleteSpec& spec = result.spec;
    long long sum = std::accumulate(spec.turning.begin(), spec.turning.end(), 0LL);
    for (const ConePoint& cone : spec.cones) sum += spec.q - cone.k;
    const int m = static_cast<int>(context.topology.loops.size());
    EXPECT_EQ(sum, spec.q * (2 - 2 * context.topology.genus - m));
    for (std::size_t j = 0; j < asked.turning.size(); ++j)
      if (asked.turning[j]) {
        EXPECT_EQ(spec.turning[j], *asked.turning[j]);
      }
    for (std::size_t j = 0; j < context.topology.loops.size(); ++j)
      EXPECT_GE(spec.turning[j], turningRange(mesh, context.topology.loops[j], spec.q).lowest);
  });
}

TEST(ConeMetric, SolvesThePoissonEquationOfTheAskedCurvature) {
  forAllFields([](const TriMesh& mesh, const FieldContext& context, const HolonomySpec&,
                  const PrescribedField& result) {
    const FilledSurface& surface = context.surface;
    const PerVertex<int> k = askedIndices(mesh, result.spec);
    PerVertex<double> Lu(static_cast<std::size_t>(mesh.vertexCount()), 0.0);
    for (HalfedgeId h : mesh.halfedges())
      if (!mesh.isBoundary(h))
        Lu[mesh.tail(h)] +=
            surface.weight[mesh.edge(h)] * (result.u[mesh.tail(h)] - result.u[mesh.head(h)]);
    for (VertexId v : mesh.vertices()) {
      if (mesh.isBoundary(v)) continue;
      const double K = surface.curvature[static_cast<std::size_t>(surface.node[v])];
      EXPECT_NEAR(Lu[v], coneCurvature(k[v], result.spec.q) - K, 1e-8);
    }
    const auto [low, high] = std::minmax_element(result.u.begin(), result.u.end());
    EXPECT_NEAR(result.scaleRange, *high - *low, 1e-12);
  });
}

TEST(ConeMetric, IsConstantWhereTheSurfaceHasItsConesAlready) {
  // Surfaces of unit cubes: own angle sums are multiples of a quarter turn.
  for (const test::Shape& shape : {test::cube(2), test::doubleTorus(), test::pretzel(3, 2)}) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    HolonomySpec spec;
    for (VertexId v : mesh.vertices()) {
      const int k = static_cast<int>(std::lround(context->geometry.angleSum[v] * 2 / kPi));
      if (k != 4) spec.cones.push_back({v, k});
    }
    const Result<PrescribedField> result = prescribedField(mesh, *context, spec);
    ASSERT_TRUE(result);
    EXPECT_LT(result->scaleRange, 1e-10) << shape.name;
    EXPECT_LT(result->largestTurn, 1e-9) << shape.name << ": its own connection is trivial already";
  }
}

TEST(TrivialConnection, OfATorusWithoutConesHasNoHolonomyWhateverIsSmoothest) {
  for (const test::Shape& shape : {test::torus(8, 5), test::jittered(test::torus(12, 7), 0.05)}) {
    const TriMesh mesh = shape.mesh();
    const Result<FieldContext> context = prepareFields(mesh);
    ASSERT_TRUE(context);
    for (int q : {1, 3, 4, 7}) {
      HolonomySpec spec;
      spec.q = q;
      const Result<PrescribedField> result = prescribedField(mesh, *context, spec);
      ASSERT_TRUE(result);
      EXPECT_EQ(result->spec.handles, (std::vector<int>{0, 0})) << q;
    }
  }
}

TEST(TrivialConnection, IsTheSmallestAdjustmentOfItsClass) {
  // ω = w (du + ξ) is orthogonal, weighted by 1/w, to every change that keeps all sums: those are
  // the coexact-free, harmonic-free forms, that is w-multiples of nothing else. Checked by trying:
  // adding a multiple of any closed loop's flow ψ (Σ ψ around every node 0, no flux along
  // generators) raises Σ ω²/w.
  const TriMesh mesh = test::icosphere(3).mesh();
  const Result<FieldContext> context = prepareFields(mesh);
  ASSERT_TRUE(context);
  std::mt19937 random(5);
  const auto spec = test::randomSpec(mesh, context->topology, {4, 5, false, false}, random);
  ASSERT_TRUE(spec);
  const Result<PrescribedField> result = prescribedField(mesh, *context, *spec);
  ASSERT_TRUE(result);
  // On a sphere: flows around one face of the primal mesh (ψ = 1 on its three sides) keep all sums.
  for (FaceId f : mesh.faces()) {
    double slope = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      slope += adjustment(mesh, context->geometry, result->field, h) /
               context->surface.weight[mesh.edge(h)];
    }
    EXPECT_NEAR(slope, 0.0, 1e-9);
  }
}

TEST(OtherHandles, DifferInOneOpenRotationByOneStepAndAreAsPrescribedSmoothestFirst) {
  int choices = 0;
  forAllFields([&](const TriMesh& mesh, const FieldContext& context, const HolonomySpec& spec,
                   const PrescribedField& chosen) {
    if (context.handles.loops.empty() || chosen.spec.cones.empty()) return;
    const int q = spec.q;
    double last = 0.0;
    for (const std::vector<int>& handles : otherHandles(mesh, context, spec, chosen.spec)) {
      int changed = 0;
      for (std::size_t i = 0; i < handles.size(); ++i) {
        const int step = reduceTurn(handles[i] - chosen.spec.handles[i], q);
        if (step == 0) continue;
        ++changed;
        EXPECT_TRUE(step == 1 || step == q - 1);
        EXPECT_FALSE(i < spec.handles.size() && spec.handles[i]) << "given";
      }
      EXPECT_EQ(changed, 1);
      HolonomySpec other = toSpec(chosen.spec);
      other.handles.assign(handles.begin(), handles.end());
      const Result<PrescribedField> field = prescribedField(mesh, context, other);
      ASSERT_TRUE(field);
      EXPECT_EQ(field->spec.handles, handles);
      // What handles add to the adjustment is orthogonal to the rest in Σ ω²/w.
      double energy = 0.0;
      for (EdgeId e : mesh.edges()) {
        const HalfedgeId h = mesh.halfedge(e);
        if (mesh.isBoundary(h) || !(context.surface.weight[e] > 0.0)) continue;
        const double omega = adjustment(mesh, context.geometry, field->field, h);
        energy += omega * omega / context.surface.weight[e];
      }
      EXPECT_GE(energy, last - 1e-6 * (1.0 + last));
      last = energy;
      ++choices;
    }
  });
  EXPECT_GT(choices, 40);
}

}  // namespace
}  // namespace hgp
