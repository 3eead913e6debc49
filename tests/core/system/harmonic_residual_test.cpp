// How harmonic a map is.  Laws: a flat map has no residual; one step beyond what rounding explains is a violation.
#include "hgp/system/harmonic_residual.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/shapes.h"

namespace hgp {
namespace {

struct Flat {
  TriMesh mesh = test::grid(8, 8).mesh();
  Geometry geometry = computeGeometry(mesh);
  UvMap map;
  VertexId inner;

  Flat() {
    for (VertexId v : mesh.vertices()) {
      map.uv.push_back({mesh.position(v)[0], mesh.position(v)[1]});
      if (!mesh.isBoundary(v)) inner = v;
    }
    for (FaceId f : mesh.faces()) {
      const auto corners = mesh.corners(f);
      map.cornerUv.push_back({corners[0].i, corners[1].i, corners[2].i});
    }
  }
  HarmonicFacts facts(double gridStep = 0.0) const {
    return measureHarmonicity(mesh, geometry, map, 4, {}, gridStep);
  }
};

TEST(HarmonicResidual, IsZeroForAFlatMapAndCountsEveryInnerVertex) {
  const Flat flat;
  const HarmonicFacts facts = flat.facts();
  int inner = 0;
  for (VertexId v : flat.mesh.vertices()) inner += !flat.mesh.isBoundary(v);
  EXPECT_EQ(facts.rows, inner);
  EXPECT_EQ(facts.violated, 0);
  EXPECT_LT(facts.largestResidual, 1e-12);
}

TEST(HarmonicResidual, IsTheDisplacementOfAVertexRelativeToItsEdges) {
  Flat flat;
  flat.map.uv[static_cast<std::size_t>(flat.inner.i)][0] += 1e-3;
  const HarmonicFacts facts = flat.facts();
  EXPECT_GE(facts.violated, 1);
  EXPECT_EQ(facts.worst, flat.inner);
  double mean = 0.0;
  int sides = 0;
  for (HalfedgeId h : outgoingHalfedges(flat.mesh, flat.inner)) {
    mean += flat.geometry.unit * flat.geometry.length[h];
    ++sides;
  }
  EXPECT_NEAR(facts.largestResidual, 1e-3 / (mean / sides), 1e-5);
}

TEST(HarmonicResidual, WhatRoundingCanCauseIsNoViolationAndTwiceThatIs) {
  Flat flat;
  const double step = 1e-3;
  const auto inner = static_cast<std::size_t>(flat.inner.i);
  flat.map.uv[inner][0] += 1.3 * step;  // √2 steps are explained
  EXPECT_EQ(flat.facts(step).violated, 0);
  flat.map.uv[inner][0] += 1.5 * step;
  EXPECT_EQ(flat.facts(step).violated, 1);
}

}  // namespace
}  // namespace hgp
