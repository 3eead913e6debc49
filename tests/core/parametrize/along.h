// Maps along features, and by hand whether these are straight in them.  Role: what tests of such maps share.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hgp/parametrize/along/along_features.h"

namespace hgp::test {

inline Result<Parametrization> along(const TriMesh& mesh, const std::vector<EdgeId>& features,
                                     const ParametrizeOptions& options = {}) {
  PreparedSurface surface(mesh);
  HolonomySpec spec;
  spec.features = features;
  return parametrizeAlongFeatures(surface, spec, options);
}

/// A common coordinate on every side of every feature edge; with a grid it is an integer.
inline void expectOnLines(const std::string& name, const TriMesh& mesh, const Parametrization& run,
                          bool isOnIntegers) {
  const auto uv = [&](HalfedgeId h) {
    return run.map.uv[at(run.map.cornerUv[at(h.i / 3)][at(h.i % 3)])];
  };
  for (EdgeId e : run.spec.features) {
    HalfedgeId h = mesh.halfedge(e);
    for (int side = 0; side < 2 && h.isValid(); ++side, h = mesh.twin(h)) {
      const Vec2 a = uv(h), b = uv(TriMesh::next(h));
      ASSERT_TRUE((a[0] == b[0]) != (a[1] == b[1])) << name << " edge " << e.i;
      const double line = a[0] == b[0] ? a[0] : a[1];
      EXPECT_TRUE(!isOnIntegers || line == std::nearbyint(line)) << name << " edge " << e.i;
    }
  }
}

}  // namespace hgp::test
