// hgp::parametrize(V, F): what it promises of every row.
#include "hgp/eigen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <cstdint>
#include <random>

#include "hgp/verify/orientation.h"
#include "support/shapes.h"

namespace hgp {
namespace {

Eigen::MatrixXd positionsOf(const MeshData& mesh) {
  Eigen::MatrixXd V(static_cast<Eigen::Index>(mesh.positions.size()), 3);
  for (Eigen::Index v = 0; v < V.rows(); ++v)
    for (Eigen::Index k = 0; k < 3; ++k)
      V(v, k) = mesh.positions[static_cast<std::size_t>(v)][static_cast<std::size_t>(k)];
  return V;
}

template <typename Index>
Eigen::Matrix<Index, Eigen::Dynamic, 3> rowsOf(const MeshData& mesh) {
  Eigen::Matrix<Index, Eigen::Dynamic, 3> F(static_cast<Eigen::Index>(mesh.triangles.size()), 3);
  for (Eigen::Index f = 0; f < F.rows(); ++f)
    for (Eigen::Index k = 0; k < 3; ++k)
      F(f, k) = static_cast<Index>(
          mesh.triangles[static_cast<std::size_t>(f)][static_cast<std::size_t>(k)]);
  return F;
}

std::array<int, 3> sorted(std::array<int, 3> t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Every row of the map, against the mesh that was given.
void expectPromises(const MeshData& mesh, const MatrixMap& map) {
  ASSERT_TRUE(map.isCertified) << map.report;
  ASSERT_EQ(map.F.rows(), map.FUV.rows());
  ASSERT_EQ(map.F.rows(), map.origin.size());
  EXPECT_EQ(map.V, positionsOf(mesh));
  std::vector<char> isThere(mesh.triangles.size(), 0);
  for (Eigen::Index s = 0; s < map.F.rows(); ++s) {
    const auto uv = [&](Eigen::Index k) {
      return Vec2{map.UV(map.FUV(s, k), 0), map.UV(map.FUV(s, k), 1)};
    };
    EXPECT_GT(orientationSign(uv(0), uv(1), uv(2)), 0) << s;
    const auto from = static_cast<std::size_t>(map.origin(s));
    EXPECT_EQ(sorted({map.F(s, 0), map.F(s, 1), map.F(s, 2)}), sorted(mesh.triangles[from])) << s;
    EXPECT_EQ(isThere[from], 0);
    isThere[from] = 1;
  }
}

/// The typed facts, against the arrays and the report.
void expectFacts(const MatrixMap& map) {
  ASSERT_EQ(map.uvToVertex.size(), map.UV.rows());
  for (Eigen::Index s = 0; s < map.F.rows(); ++s)
    for (Eigen::Index k = 0; k < 3; ++k) EXPECT_EQ(map.uvToVertex(map.FUV(s, k)), map.F(s, k));
  const double step = 2.0 * M_PI / map.facts.q;
  for (Eigen::Index s = 0; s < map.seams.rows(); ++s) {
    const auto side = [&](Eigen::Index first) {
      const Eigen::RowVector2d d =
          map.UV.row(map.seams(s, first + 1)) - map.UV.row(map.seams(s, first));
      return std::complex<double>(d.x(), d.y());
    };
    EXPECT_LT(std::abs(side(2) - std::polar(1.0, step * map.seams(s, 4)) * side(0)), 1e-9) << s;
    for (Eigen::Index end = 0; end < 2; ++end)
      EXPECT_EQ(map.uvToVertex(map.seams(s, end)), map.uvToVertex(map.seams(s, 2 + end)));
  }
  EXPECT_TRUE(map.facts.isCertified);
  int triangles = 0, left = 0;
  for (const api::ComponentFacts& component : map.facts.components) {
    EXPECT_TRUE(component.isCertified && component.reasons.empty());
    EXPECT_EQ(component.positive, component.triangles);
    triangles += component.triangles;
    left += map.facts.q * (2 - 2 * component.genus - component.boundaries);
    for (const api::ConeFact& cone : component.cones) left -= map.facts.q - cone.k;
    for (const api::TurningFact& turning : component.turnings) left -= turning.l;
  }
  EXPECT_EQ(triangles, map.F.rows());
  EXPECT_EQ(left, 0) << "Lemma 6.2, from the typed numbers alone";
}

/// Faces without a row of the map, whose given index is in `gone`.
void expectGone(const MatrixMap& map, std::size_t count, const std::vector<int>& gone) {
  std::vector<int> missing;
  std::size_t s = 0;
  for (int f = 0; f < static_cast<int>(count); ++f) {
    if (s < static_cast<std::size_t>(map.origin.size()) &&
        map.origin(static_cast<Eigen::Index>(s)) == f)
      ++s;
    else
      missing.push_back(f);
  }
  EXPECT_EQ(missing, gone);
}

TEST(EigenMap, EveryRowIsPositiveWhateverWasRepaired) {
  std::mt19937 random(7);
  for (const test::Shape& shape : {test::icosphere(3), test::torus(9, 6), test::disk(4)}) {
    const auto count = static_cast<int>(shape.data.triangles.size());
    MeshData mesh = shape.data;
    for (int n = 0; n < 5; ++n) {
      auto& t = mesh.triangles[random() % mesh.triangles.size()];
      std::swap(t[0], t[1]);
    }
    mesh.triangles.push_back({3, 4, 4});
    mesh.triangles.push_back({mesh.triangles[2][1], mesh.triangles[2][2], mesh.triangles[2][0]});
    const Result<MatrixMap> map = parametrize(positionsOf(mesh), rowsOf<int>(mesh));
    ASSERT_TRUE(map) << map.error().message;
    expectPromises(mesh, *map);
    expectGone(*map, mesh.triangles.size(), {count, count + 1});
  }
}

TEST(EigenMap, AHealthyMeshKeepsItsRows) {
  const MeshData mesh = test::torus(9, 6).data;
  for (const auto& map : {parametrize(positionsOf(mesh), rowsOf<std::int64_t>(mesh)),
                          parametrize(positionsOf(mesh), rowsOf<std::uint32_t>(mesh)),
                          parametrize(positionsOf(mesh), rowsOf<short>(mesh))}) {
    ASSERT_TRUE(map) << map.error().message;
    expectPromises(mesh, *map);
    EXPECT_EQ(map->F, rowsOf<int>(mesh));
  }
}

TEST(EigenMap, StrictOptionsRefuseWhatNeedsRepairs) {
  MeshData mesh = test::icosphere(2).data;
  std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
  MatrixOptions options;
  options.load.isStrict = true;
  const Result<MatrixMap> map = parametrize(positionsOf(mesh), rowsOf<int>(mesh), options);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, ErrorCode::kUnsupported) << map.error().message;
}

template <typename Index>
void expectRefused(Index wrong, const std::string& named) {
  const MeshData mesh = test::icosphere(2).data;
  auto F = rowsOf<Index>(mesh);
  F(3, 1) = wrong;
  const Result<MatrixMap> map = parametrize(positionsOf(mesh), F);
  ASSERT_FALSE(map) << named;
  EXPECT_EQ(map.error().code, ErrorCode::kMalformed);
  EXPECT_EQ(map.error().message, "row 3 of F names the vertex " + named + "; V has " +
                                     std::to_string(mesh.positions.size()) + " rows, from 0");
}

TEST(EigenMap, IndicesAreComparedBeforeTheyAreNarrowed) {
  expectRefused<std::int64_t>(std::int64_t{1} << 32, "4294967296");
  expectRefused<std::int64_t>(-1, "-1");
  expectRefused<std::uint64_t>(~std::uint64_t{0}, "18446744073709551615");
  expectRefused<std::uint32_t>(4294967295U, "4294967295");
  expectRefused<int>(42, "42");
}

TEST(EigenMap, ANegativeNumberOfConesIsRefused) {
  const MeshData mesh = test::icosphere(2).data;
  MatrixOptions options;
  options.solve.coneCount = -3;
  const Result<MatrixMap> map = parametrize(positionsOf(mesh), rowsOf<int>(mesh), options);
  ASSERT_FALSE(map);
  EXPECT_EQ(map.error().code, ErrorCode::kUsage);
  EXPECT_NE(map.error().message.find("not -3"), std::string::npos) << map.error().message;
}

TEST(Eigen, FactsAreTypedAndAgreeWithTheArrays) {
  for (const auto& shape : {test::icosphere(2), test::torus(12, 9), test::disk(5)}) {
    const auto map = parametrize(positionsOf(shape.data), rowsOf<int>(shape.data));
    ASSERT_TRUE(map);
    expectFacts(*map);
  }
}

TEST(Eigen, ArraysCanBeMovedOutOfASessionAndStoredResultsKeepTheirs) {
  const test::Shape shape = test::torus(12, 9);
  api::Session session;
  ASSERT_TRUE(session.loadArrays(shape.data.positions, shape.data.triangles, {}));
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const std::vector<double> uv = session.uv();
  const double* place = session.uv().data();
  const api::MapArrays moved = session.release();
  EXPECT_EQ(moved.uv, uv);
  EXPECT_EQ(moved.uv.data(), place) << "moved, not copied";
  EXPECT_FALSE(session.hasResult());
  EXPECT_TRUE(session.release().uv.empty());
  ASSERT_TRUE(session.parametrize(std::nullopt, {}));
  const api::StoredResult kept = session.result();
  EXPECT_EQ(session.release().uv, uv);
  ASSERT_TRUE(session.use(kept));
  EXPECT_EQ(session.uv(), uv);
  EXPECT_EQ(session.seams().size(), moved.seams.size());
}

}  // namespace
}  // namespace hgp
