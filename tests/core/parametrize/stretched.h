// A surface of very thin triangles, with many cones.  Role: what only evened edge lengths give a map.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>

#include "hgp/parametrize/parametrize.h"
#include "support/shapes.h"

namespace hgp::test {

/// A torus of squares; stretched, most of its triangles are very thin.
inline TriMesh stretched(double factor, int n = 4) {
  Shape shape = jittered(pretzel(1, n), 0.05);
  for (auto& p : shape.data.positions) p[0] *= factor;
  return shape.mesh();
}

/// Twelve cones of 3π/2 and as many of 5π/2, spread over the vertices.
inline HolonomySpec manyCones(const TriMesh& mesh) {
  HolonomySpec spec;
  spec.q = 4;
  const int step = mesh.vertexCount() / 24;
  for (int i = 0; i < 24; ++i)
    spec.cones.push_back({VertexId{i * step + i % 5}, i % 2 == 0 ? 5 : 3});
  return spec;
}

inline bool isEvened(const Round& round) { return round.method.starts_with("evened lengths: "); }

inline long long evenedRounds(const Parametrization& p) {
  return std::count_if(p.rounds.begin(), p.rounds.end(), isEvened);
}

inline void expectMappedWithEvenedLengths(const TriMesh& mesh, const Parametrization& p) {
  ASSERT_TRUE(p.isCertified);
  EXPECT_TRUE(certify(mesh, p.spec, p.map).isCertified);
  EXPECT_GT(evenedRounds(p), 0);
  EXPECT_TRUE(isEvened(p.rounds.back()));
  EXPECT_LE(p.rounds.size(), 24u);
  ASSERT_FALSE(p.notes.empty());
  EXPECT_EQ(p.notes.back().code, "map-evened-lengths");
}

}  // namespace hgp::test
