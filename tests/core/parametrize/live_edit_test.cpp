#include "hgp/parametrize/live_edit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/parametrize/parametrize.h"
#include "support/random.h"
#include "support/shapes.h"

namespace hgp {
namespace {

/// A surface with automatic cones and its certified map.
struct Solved {
  explicit Solved(const test::Shape& shape, const std::vector<ConePoint>& prescribed = {})
      : mesh(shape.mesh()), surface(mesh) {
    HolonomySpec spec;
    spec.cones = prescribed;
    if (prescribed.empty()) {
      const Result<CompleteSpec> cones = suggestCones(surface, {});
      EXPECT_TRUE(cones) << shape.name;
      spec = toSpec(*cones);
    }
    Result<Parametrization> run = parametrize(surface, spec, {});
    EXPECT_TRUE(run && run->isCertified) << shape.name;
    if (run) result = std::move(*run);
  }
  TriMesh mesh;
  PreparedSurface surface;
  Parametrization result;

  LiveEdit edit(VertexId cone) {
    Result<LiveEdit> made = LiveEdit::begin(surface, result.spec, result.map, cone);
    EXPECT_TRUE(made) << made.error().message;
    return std::move(*made);
  }
  bool mayHoldCone(VertexId v, VertexId moved) const {
    const auto& cones = result.spec.cones;
    return !mesh.isBoundary(v) && std::none_of(cones.begin(), cones.end(), [&](const ConePoint& c) {
      return c.vertex == v && v != moved;
    });
  }
};

std::vector<test::Shape> dragged() {
  return {test::jittered(test::icosphere(8), 0.01),
          test::torus(36, 20),
          test::pretzel(2, 3),
          test::jittered(test::pretzel(3, 2), 0.05),
          test::cylinder(24, 12),
          test::puncturedTorus(30, 16),
          test::cube(8)};
}

struct Walk {
  int frames = 0, certified = 0, heat = 0, handles = 0;
};

/// Walks from a cone over random edges, and checks every frame.
Walk walk(Solved& on, VertexId cone, int steps, std::mt19937& random) {
  Walk out;
  LiveEdit edit = on.edit(cone);
  VertexId v = cone;
  for (int step = 0; step < steps; ++step) {
    std::vector<VertexId> open;
    for (HalfedgeId h : outgoingHalfedges(on.mesh, v))
      if (on.mayHoldCone(on.mesh.head(h), cone)) open.push_back(on.mesh.head(h));
    if (open.empty()) break;
    v = open[static_cast<std::size_t>(test::randomBelow(random, static_cast<int>(open.size())))];
    const Result<LiveFrame> frame = edit.moveTo(v);
    EXPECT_TRUE(frame);
    if (!frame) break;
    ++out.frames;
    out.heat += frame->state == LiveState::kHeat;
    out.handles += frame->spec.handles != on.result.spec.handles;
    if (frame->state == LiveState::kHeat) {
      EXPECT_TRUE(edit.beginHere());
      continue;
    }
    EXPECT_TRUE(checkPrescription(on.mesh, on.surface.topology(), toSpec(frame->spec)));
    const Certificate again = certify(on.mesh, frame->spec, frame->map);
    EXPECT_EQ(again.isCertified, frame->state == LiveState::kCertified);
    out.certified += again.isCertified;
    int others = 0;
    for (std::size_t f = 0; f < frame->map.cornerUv.size(); ++f)
      for (std::size_t k = 0; k < 3; ++k)
        others += frame->copyOf[static_cast<std::size_t>(frame->map.cornerUv[f][k])] !=
                  on.mesh.corners(FaceId(static_cast<int>(f)))[k];
    EXPECT_EQ(others, 0);
    if (frame->wantsAnchor && !edit.beginHere()) ADD_FAILURE() << "no new anchor";
  }
  return out;
}

TEST(LiveEdit, MostFramesAreCertifiedAndAnIndependentVerifierAgrees) {
  std::mt19937 random(5);
  Walk all;
  for (const test::Shape& shape : dragged()) {
    SCOPED_TRACE(shape.name);
    Solved on(shape);
    for (int drag = 0; drag < 4; ++drag) {
      const auto& cones = on.result.spec.cones;
      if (cones.empty()) break;
      const Walk one = walk(
          on,
          cones[static_cast<std::size_t>(test::randomBelow(random, static_cast<int>(cones.size())))]
              .vertex,
          12, random);
      all.frames += one.frames;
      all.certified += one.certified;
      all.heat += one.heat;
    }
  }
  EXPECT_GT(all.frames, 200);
  EXPECT_GE(all.certified, 0.95 * all.frames) << all.certified << " of " << all.frames;
}

/// A cone of index k at vertex 0, and others of 3 or 5 that complete it, q = 4.
std::vector<ConePoint> withLargeCone(const TriMesh& mesh, int k) {
  const int euler = mesh.vertexCount() - mesh.faceCount() / 2, missing = 4 * euler + k - 4;
  std::vector<ConePoint> cones{{VertexId(0), k}};
  const int half = mesh.vertexCount() / 2, count = std::abs(missing);
  for (int i = 0; i < count; ++i)
    cones.push_back({VertexId(half + i * (half - 1) / count), missing > 0 ? 3 : 5});
  return cones;
}

// Without any frame conditions one of ten frames is certified; with those of patches alone, 136 of 144.
TEST(LiveEdit, ConesOfLargeAnglesTakeTheMapWithThem) {
  std::mt19937 random(3);
  Walk all;
  for (const test::Shape& shape :
       {test::jittered(test::pretzel(2, 3), 0.02), test::jittered(test::pretzel(3, 3), 0.02),
        test::jittered(test::torus(48, 20), 0.02)})
    for (const int k : {6, 7}) {
      Solved on(shape, withLargeCone(shape.mesh(), k));
      for (int drag = 0; drag < 2; ++drag) {
        const Walk one = walk(on, VertexId(0), 12, random);
        all.frames += one.frames;
        all.certified += one.certified;
      }
    }
  EXPECT_EQ(all.frames, 144);
  EXPECT_GE(all.certified, 139) << all.certified << " of " << all.frames;
}

/// Begins to drag the first cone of every surface that has one.
template <class Act>
void withFirstCones(Act act) {
  for (const test::Shape& shape : dragged()) {
    SCOPED_TRACE(shape.name);
    Solved on(shape);
    if (on.result.spec.cones.empty()) continue;
    const VertexId cone = on.result.spec.cones.front().vertex;
    LiveEdit edit = on.edit(cone);
    act(on, cone, edit);
  }
}

/// Edges from v, by vertex.
PerVertex<int> edgesFrom(const TriMesh& mesh, VertexId v) {
  PerVertex<int> edges(mesh.vertexCount(), -1);
  std::vector<VertexId> queue{v};
  edges[v] = 0;
  for (std::size_t i = 0; i < queue.size(); ++i)
    for (HalfedgeId h : outgoingHalfedges(mesh, queue[i]))
      if (VertexId w = mesh.head(h); edges[w] < 0) {
        edges[w] = edges[queue[i]] + 1;
        queue.push_back(w);
      }
  return edges;
}

TEST(LiveEdit, AVertexFarAwayIsReachedInStepsEachOfWhichIsNearer) {
  int reached = 0, leaps = 0;
  withFirstCones([&](Solved& on, VertexId cone, LiveEdit& edit) {
    const PerVertex<int> fromCone = edgesFrom(on.mesh, cone);
    VertexId to = cone;  // the farthest of up to 15 edges
    for (VertexId v : on.mesh.vertices())
      if (fromCone[v] <= 15 && fromCone[v] > fromCone[to] && on.mayHoldCone(v, cone)) to = v;
    if (fromCone[to] < 6) return;
    ++leaps;
    const PerVertex<int> left = edgesFrom(on.mesh, to);
    Result<LiveFrame> frame = edit.moveTo(to);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->state, LiveState::kHeat);
    while (frame->state == LiveState::kHeat) {
      const int before = left[edit.cone().vertex];
      const Result<bool> isNearer = edit.beginToward(to);
      ASSERT_TRUE(isNearer) << isNearer.error().message;
      if (!*isNearer) break;
      EXPECT_LT(left[edit.cone().vertex], before);
      frame = edit.moveTo(to);
      ASSERT_TRUE(frame);
    }
    reached += frame->state == LiveState::kCertified;
  });
  EXPECT_GE(leaps, 5);
  EXPECT_GE(reached, leaps - 1) << "of " << leaps;
}

TEST(LiveEdit, BackAtTheStartTheMapIsTheOneBefore) {
  withFirstCones([&](Solved& on, VertexId cone, LiveEdit& edit) {
    for (HalfedgeId h : outgoingHalfedges(on.mesh, cone))
      if (on.mayHoldCone(on.mesh.head(h), cone)) {
        ASSERT_TRUE(edit.moveTo(on.mesh.head(h)));
      }
    const Result<LiveFrame> back = edit.moveTo(cone);
    ASSERT_TRUE(back);
    ASSERT_EQ(back->state, LiveState::kCertified);
    ASSERT_EQ(back->map.uv.size(), on.result.map.uv.size());
    EXPECT_EQ(back->map.cornerUv, on.result.map.cornerUv);
    EXPECT_EQ(back->spec.handles, on.result.spec.handles);
    // A stored map may be anywhere in the plane: compared relative to the first copy.
    double size = 0.0, worst = 0.0;
    const auto& a = back->map.uv;
    const auto& b = on.result.map.uv;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t k = 0; k < 2; ++k) {
        size = std::max(size, std::abs(b[i][k] - b[0][k]));
        worst = std::max(worst, std::abs((a[i][k] - a[0][k]) - (b[i][k] - b[0][k])));
      }
    EXPECT_LE(worst, 1e-11 * size);
  });
}

TEST(LiveEdit, CrossingAGeneratorChangesItsRotationAndReversesNoTriangle) {
  // With the rotations held instead, the map beyond the generator is another one, and folds.
  std::mt19937 random(8);
  int crossed = 0;
  for (const test::Shape& shape : {test::pretzel(2, 3), test::pretzel(3, 2)}) {
    Solved on(shape);
    const int before = crossed;
    for (const ConePoint& cone : on.result.spec.cones) {
      if (crossed >= before + 6) break;
      LiveEdit edit = on.edit(cone.vertex);
      for (HalfedgeId h : outgoingHalfedges(on.mesh, cone.vertex)) {
        const VertexId to = on.mesh.head(h);
        if (!on.mayHoldCone(to, cone.vertex)) continue;
        const Result<LiveFrame> frame = edit.moveTo(to);
        ASSERT_TRUE(frame);
        if (frame->spec.handles == on.result.spec.handles) continue;
        ++crossed;
        EXPECT_EQ(frame->state, LiveState::kCertified) << shape.name << " vertex " << to.i;
        CompleteSpec held = frame->spec;
        held.handles = on.result.spec.handles;
        EXPECT_FALSE(certify(on.mesh, held, frame->map).isCertified);
      }
    }
  }
  EXPECT_GT(crossed, 5);
}

TEST(LiveEdit, RefusesPlacesWhereNoConeCanBe) {
  Solved on(test::cylinder(24, 12));
  VertexId regular;
  for (VertexId v : on.mesh.vertices())
    if (!on.mesh.isBoundary(v) && on.mayHoldCone(v, VertexId())) regular = v;
  EXPECT_FALSE(LiveEdit::begin(on.surface, on.result.spec, on.result.map, regular));
  Solved sphere(test::jittered(test::icosphere(6), 0.01));
  const auto& cones = sphere.result.spec.cones;
  LiveEdit edit = sphere.edit(cones[0].vertex);
  const Result<LiveFrame> onOther = edit.moveTo(cones[1].vertex);
  ASSERT_FALSE(onOther);
  EXPECT_EQ(onOther.error().code, ErrorCode::kUsage);
  // Far away there is a conformal factor and no map.
  const Result<LiveFrame> far = edit.moveTo([&] {
    VertexId farthest = cones[0].vertex;
    double most = -1.0;
    for (VertexId v : sphere.mesh.vertices()) {
      double square = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = sphere.mesh.position(v)[i] - sphere.mesh.position(cones[0].vertex)[i];
        square += d * d;
      }
      if (square > most && sphere.mayHoldCone(v, cones[0].vertex)) {
        most = square;
        farthest = v;
      }
    }
    return farthest;
  }());
  ASSERT_TRUE(far);
  EXPECT_EQ(far->state, LiveState::kHeat);
  EXPECT_TRUE(far->map.uv.empty());
  EXPECT_EQ(far->u.size(), sphere.mesh.vertexCount());
}

TEST(LiveEdit, RefusesAMapWithOtherSeamsThanItsCones) {
  Solved on(test::pretzel(2, 3));
  UvMap moved = on.result.map;
  moved.uv[0][0] += 0.3;
  const auto refused =
      LiveEdit::begin(on.surface, on.result.spec, moved, on.result.spec.cones[0].vertex);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kUsage);
}

}  // namespace
}  // namespace hgp
