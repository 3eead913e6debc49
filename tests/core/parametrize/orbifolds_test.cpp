// The Euclidean orbifolds of the sphere: three cones leave one harmonic map up to similarity, the
// solution of a linear system. The cone program must find exactly that.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "support/prescriptions.h"
#include "support/shapes.h"

namespace hgp {
namespace {

struct Orbifold {
  int q;
  std::vector<int> k;
};

/// Cones far apart.
HolonomySpec sphereSpec(const TriMesh& mesh, const Orbifold& orbifold) {
  const std::vector<VertexId> places = test::spreadVertices(mesh, 4);
  HolonomySpec spec;
  spec.q = orbifold.q;
  for (std::size_t i = 0; i < orbifold.k.size(); ++i)
    spec.cones.push_back({places[i], orbifold.k[i]});
  return spec;
}

const std::vector<Orbifold>& triangleOrbifolds() {
  static const std::vector<Orbifold> all = {{3, {1, 1, 1}},   // (2π/3, 2π/3, 2π/3)
                                            {6, {2, 2, 2}},   // the same with a larger group
                                            {4, {1, 1, 2}},   // (π/2, π/2, π)
                                            {6, {1, 2, 3}}};  // (π/3, 2π/3, π)
  return all;
}

/// All harmonic maps of the setup: a basis of the kernel of L, over the copies.
Eigen::MatrixXcd harmonicMaps(const SeamlessSetup& setup) {
  Eigen::FullPivLU<Eigen::MatrixXcd> lu{Eigen::MatrixXcd(setup.harmonic.rows)};
  lu.setThreshold(1e-9);
  const Eigen::MatrixXcd kernel = lu.kernel();
  return setup.unknowns.copies * kernel;
}

Eigen::VectorXcd uvOf(const UvMap& map) {
  Eigen::VectorXcd z(static_cast<Eigen::Index>(map.uv.size()));
  for (std::size_t c = 0; c < map.uv.size(); ++c)
    z[static_cast<Eigen::Index>(c)] = {map.uv[c][0], map.uv[c][1]};
  return z;
}

double energyOf(const Parametrization& p) { return p.rounds.back().laplacianEnergy; }

TEST(Orbifold, OfThreeConesIsCertifiedAndEqualToTheLinearSolution) {
  for (const test::Shape& shape : {test::icosphere(3), test::jittered(test::icosphere(3), 0.04)}) {
    const TriMesh mesh = shape.mesh();
    for (const Orbifold& orbifold : triangleOrbifolds()) {
      SCOPED_TRACE(shape.name + " q=" + std::to_string(orbifold.q));
      const HolonomySpec spec = sphereSpec(mesh, orbifold);
      const Result<Parametrization> p = parametrize(mesh, spec, {});
      ASSERT_TRUE(p) << p.error().message;
      EXPECT_TRUE(p->isCertified);
      EXPECT_EQ(p->rounds.size(), 1u);

      std::vector<StageTime> times;
      PreparedSurface surface(mesh);
      const Result<SeamlessSetup> setup = prepareSeamless(surface, spec, {}, times);
      ASSERT_TRUE(setup);
      const Eigen::MatrixXcd linear = harmonicMaps(*setup);
      ASSERT_EQ(linear.cols(), 2) << "one map up to similarity";
      const Eigen::VectorXcd z = uvOf(p->map);
      ASSERT_EQ(z.size(), linear.rows());
      // Closest similarity image of the linear solution: a combination of the kernel.
      const Eigen::VectorXcd fit = linear * linear.colPivHouseholderQr().solve(z);
      const double extent = (z.array() - z.mean()).abs().maxCoeff();
      EXPECT_LT((fit - z).cwiseAbs().maxCoeff(), 1e-11 * extent);
      EXPECT_LT(energyOf(*p), 1e-20);
    }
  }
}

TEST(Orbifold, OfFourConesOfPiIsCertified) {
  for (const test::Shape& shape : {test::icosphere(4), test::jittered(test::icosphere(4), 0.03)}) {
    const TriMesh mesh = shape.mesh();
    const Result<Parametrization> p = parametrize(mesh, sphereSpec(mesh, {2, {1, 1, 1, 1}}), {});
    ASSERT_TRUE(p) << p.error().message;
    EXPECT_TRUE(p->isCertified) << shape.name;
    EXPECT_EQ(p->certificate.q, 2);
  }
}

TEST(Orbifold, AreaIsThatOfTheSurfaceAndTheBoxIsCentred) {
  const TriMesh mesh = test::icosphere(3).mesh();
  const Result<Parametrization> p = parametrize(mesh, sphereSpec(mesh, {3, {1, 1, 1}}), {});
  ASSERT_TRUE(p);
  double area = 0.0, surface = 0.0;
  const Geometry geometry = computeGeometry(mesh);
  for (FaceId f : mesh.faces()) {
    const auto& t = p->map.cornerUv[static_cast<std::size_t>(f.i)];
    const auto at = [&](std::size_t k) {
      const Vec2& uv = p->map.uv[static_cast<std::size_t>(t[k])];
      return Complex(uv[0], uv[1]);
    };
    area += 0.5 * std::imag(std::conj(at(1) - at(0)) * (at(2) - at(0)));
    surface += geometry.area[f] * geometry.unit * geometry.unit;
  }
  EXPECT_NEAR(area, surface, 1e-9 * surface);
  Vec2 low = p->map.uv[0], high = low;
  for (const Vec2& uv : p->map.uv)
    for (std::size_t i = 0; i < 2; ++i) {
      low[i] = std::min(low[i], uv[i]);
      high[i] = std::max(high[i], uv[i]);
    }
  EXPECT_NEAR(low[0], -high[0], 1e-9);
  EXPECT_NEAR(low[1], -high[1], 1e-9);
}

}  // namespace
}  // namespace hgp
