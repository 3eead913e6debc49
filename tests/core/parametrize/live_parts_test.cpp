#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/parametrize/live/moved_cut.h"
#include "hgp/parametrize/live/moved_field.h"
#include "support/seamless.h"

namespace hgp::live {
namespace {

/// A path of up to `length` edges from the cone over interior vertices that are no cones.
std::vector<HalfedgeId> randomPath(const test::CutSurface& on, VertexId cone, int length,
                                   std::mt19937& random) {
  std::vector<HalfedgeId> path;
  std::vector<VertexId> visited{cone};
  for (int step = 0; step < length; ++step) {
    std::vector<HalfedgeId> open;
    for (HalfedgeId h : outgoingHalfedges(on.mesh, visited.back())) {
      const VertexId to = on.mesh.head(h);
      if (!on.mesh.isBoundary(to) && !on.isCone(to) &&
          std::find(visited.begin(), visited.end(), to) == visited.end())
        open.push_back(h);
    }
    if (open.empty()) break;
    path.push_back(
        open[static_cast<std::size_t>(test::randomBelow(random, static_cast<int>(open.size())))]);
    visited.push_back(on.mesh.head(path.back()));
  }
  return path;
}

/// law(surface, cone, path) for random paths from cones of all small surfaces.
template <class Law>
void forRandomPaths(const Law& law) {
  std::mt19937 random(11);
  int count = 0;
  for (const test::CutSurface& s : test::cutSurfaces())
    for (const ConePoint& cone : s.field.spec.cones) {
      if (s.mesh.isBoundary(cone.vertex)) continue;
      const auto path = randomPath(s, cone.vertex, 1 + test::randomBelow(random, 4), random);
      if (path.empty()) continue;
      SCOPED_TRACE(s.name + ", cone " + std::to_string(cone.vertex.i));
      law(s, cone, path);
      ++count;
    }
  EXPECT_GT(count, 150);
}

TEST(MovedCut, SeamsHoldForAllUnknownsWhereverThePathGoes) {
  // Also where it crosses or follows other seams, or ends on one.
  std::mt19937 random(12);
  int onSeams = 0;
  forRandomPaths([&](const test::CutSurface& s, const ConePoint& cone, const auto& path) {
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    MovedCut cut(s.mesh, s.cut, s.seams, unknowns, cone.vertex);
    cut.move(path);
    for (HalfedgeId h : path)
      onSeams += s.cut.copy[TriMesh::next(h)] != s.cut.firstCopy[s.mesh.head(h)] ||
                 s.cut.isSeam[s.mesh.edge(h)];
    Eigen::VectorXcd x(unknowns.count);
    for (Complex& value : x) value = {test::randomReal(random), test::randomReal(random)};
    const auto edge = [&](HalfedgeId h) {
      return valueOf(cut.termsOf(TriMesh::next(h)), x) - valueOf(cut.termsOf(h), x);
    };
    for (HalfedgeId h : s.mesh.halfedges()) {
      if (s.mesh.isBoundary(h)) continue;
      const Complex here = edge(h), there = -edge(s.mesh.twin(h));
      ASSERT_NEAR(std::abs(there - rotation(cut.turnAcross(h), s.seams.q) * here), 0.0, 1e-9)
          << "edge " << s.mesh.edge(h).i;
    }
  });
  EXPECT_GT(onSeams, 50);
}

TEST(MovedCut, TurnsAroundVerticesAreThoseOfTheConesWhereTheyNowAre) {
  forRandomPaths([&](const test::CutSurface& s, const ConePoint& cone, const auto& path) {
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    MovedCut cut(s.mesh, s.cut, s.seams, unknowns, cone.vertex);
    const auto around = [&](VertexId v) {
      int sum = 0;
      for (HalfedgeId h : outgoingHalfedges(s.mesh, v)) sum += cut.turnAcross(TriMesh::previous(h));
      return reduceTurn(sum, s.seams.q);
    };
    PerVertex<int> before(static_cast<std::size_t>(s.mesh.vertexCount()), 0);
    for (VertexId v : s.mesh.vertices())
      if (!s.mesh.isBoundary(v) && !s.mesh.isIsolated(v)) before[v] = around(v);
    cut.move(path);
    const VertexId to = s.mesh.head(path.back());
    for (VertexId v : s.mesh.vertices()) {
      if (s.mesh.isBoundary(v) || s.mesh.isIsolated(v)) continue;
      const int expected = v == to ? before[cone.vertex] : v == cone.vertex ? 0 : before[v];
      ASSERT_EQ(around(v), expected) << "vertex " << v.i;
    }
  });
}

TEST(MovedCut, CornersThatShareAUvVertexHaveTheSamePosition) {
  forRandomPaths([&](const test::CutSurface& s, const ConePoint& cone, const auto& path) {
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    MovedCut cut(s.mesh, s.cut, s.seams, unknowns, cone.vertex);
    cut.move(path);
    Eigen::VectorXcd x = Eigen::VectorXcd::Random(unknowns.count);
    std::vector<std::optional<Complex>> position(static_cast<std::size_t>(cut.uvCount()));
    for (HalfedgeId h : s.mesh.halfedges()) {
      const Complex here = valueOf(cut.termsOf(h), x);
      auto& known = position[static_cast<std::size_t>(cut.uvOf(h))];
      if (known) {
        ASSERT_NEAR(std::abs(*known - here), 0.0, 1e-9);
      }
      known = here;
    }
    cut.move({});
    EXPECT_EQ(cut.uvCount(), s.cut.vertexCount());
    for (HalfedgeId h : s.mesh.halfedges()) ASSERT_EQ(cut.uvOf(h), s.cut.copy[h].i);
  });
}

TEST(MovedField, IsATrivialConnectionWithTheConeWhereItNowIs) {
  // Frames turn by ω = w (du + ξ) against transport, with the conformal factor u of the new cones and ξ closed; the
  // rotations of the charts they are combed in are the new holonomy.
  int crossings = 0, faces = 0;
  forRandomPaths([&](const test::CutSurface& s, const ConePoint& cone, const auto& path) {
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    MovedCut cut(s.mesh, s.cut, s.seams, unknowns, cone.vertex);
    cut.move(path);
    MovedField moved(s.mesh, s.context);
    const int q = s.field.spec.q;
    const VertexId to = s.mesh.head(path.back());
    moved.move(q, cone, to, cut);
    HolonomySpec spec = toSpec(s.field.spec);
    for (ConePoint& c : spec.cones)
      if (c.vertex == cone.vertex) c.vertex = to;
    for (std::size_t i = 0; i < spec.handles.size(); ++i) {
      int along = 0;
      for (HalfedgeId h : s.context.handles.loops[i].crossed) along += cut.turnAcross(h);
      EXPECT_EQ(reduceTurn(along, q), reduceTurn(*spec.handles[i] + moved.handleChange()[i], q));
      crossings += moved.handleChange()[i] != 0;
      spec.handles[i] = reduceTurn(along, q);
    }
    const Result<PrescribedField> fresh = prescribedField(s.mesh, s.context, spec);
    ASSERT_TRUE(fresh) << fresh.error().message;
    const auto u = [&](VertexId v) { return s.field.u[v] + moved.scaleAt(v); };
    const VertexId some = s.mesh.tail(HalfedgeId(0));
    for (VertexId v : s.mesh.vertices()) {
      if (!s.mesh.isIsolated(v)) {
        ASSERT_NEAR(fresh->u[v] - fresh->u[some], u(v) - u(some), 1e-8);
      }
    }
    // Frames are known up to full turns only, which must be fewer than ω.
    if (std::max(s.field.largestTurn, fresh->largestTurn) > 2.5) return;
    const auto angle = [&](FaceId f) { return s.seams.frameAngle[f] + moved.angleAt(f); };
    const auto omega = [&](HalfedgeId h) {
      const FaceId f = TriMesh::face(h), g = TriMesh::face(s.mesh.twin(h));
      return principalAngle(angle(g) - angle(f) - transport(s.mesh, s.context.geometry, h) +
                            turnAngle(cut.turnAcross(h), q));
    };
    for (FaceId f : s.mesh.faces()) {
      double around = 0.0;
      bool isWhole = true;
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        const double w = s.context.surface.weight[s.mesh.edge(h)];
        isWhole = isWhole && !s.mesh.isBoundary(h) && w > 1e-3;
        if (isWhole) around += omega(h) / w - (u(s.mesh.head(h)) - u(s.mesh.tail(h)));
      }
      if (!isWhole) continue;
      ++faces;
      ASSERT_NEAR(around, 0.0, 1e-6) << "face " << f.i;
    }
  });
  EXPECT_GT(crossings, 10);
  EXPECT_GT(faces, 5000);
}

}  // namespace
}  // namespace hgp::live
