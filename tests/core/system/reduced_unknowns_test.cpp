#include "hgp/system/reduced_unknowns.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "support/seamless.h"

namespace hgp {
namespace {

struct Reduced {
  const test::CutSurface* surface;
  ReducedUnknowns unknowns;
};

const std::vector<Reduced>& reducedSurfaces() {
  const std::vector<test::CutSurface>& surfaces = test::cutSurfaces();
  static const std::vector<Reduced> all = [&] {
    std::vector<Reduced> list;
    for (const test::CutSurface& s : surfaces)
      list.push_back({&s, reduceUnknowns(s.mesh, s.cut, s.seams)});
    return list;
  }();
  return all;
}

Eigen::VectorXcd randomVector(Eigen::Index n, std::mt19937& random) {
  Eigen::VectorXcd x(n);
  for (Eigen::Index i = 0; i < n; ++i) x[i] = {test::randomReal(random), test::randomReal(random)};
  return x;
}

/// Residual of (12) at the seam edge of h:  (z_j − z_i) on the far side − e^{i2πr/q} (z_j − z_i).
Complex seamResidual(const test::CutSurface& s, HalfedgeId h, const Eigen::VectorXcd& z) {
  const HalfedgeId twin = s.mesh.twin(h);
  const auto at = [&](HalfedgeId g) { return z[s.cut.copy[g].i]; };
  const Complex own = at(TriMesh::next(h)) - at(h);
  const Complex across = at(twin) - at(TriMesh::next(twin));
  return across - rotation(s.seams.rotation[h], s.seams.q) * own;
}

TEST(ReducedUnknowns, AnyValuesFulfilTheRotationConditionsExactly) {
  std::mt19937 random(53);
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    const Eigen::VectorXcd z = unknowns.copies * randomVector(unknowns.count, random);
    const double scale = 1.0 + z.cwiseAbs().maxCoeff();
    for (HalfedgeId h : s->mesh.halfedges())
      if (!s->mesh.isBoundary(h) && s->cut.isSeam[s->mesh.edge(h)]) {
        EXPECT_LT(std::abs(seamResidual(*s, h, z)), 1e-12 * scale) << s->name;
      }
  }
}

TEST(ReducedUnknowns, AreReadBackFromTheMapTheyMake) {
  std::mt19937 random(59);
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    const Eigen::VectorXcd x = randomVector(unknowns.count, random);
    const Eigen::VectorXcd z = unknowns.copies * x;
    const Eigen::VectorXcd read =
        readUnknowns(s->mesh, s->cut, s->seams, unknowns, {z.data(), z.data() + z.size()});
    ASSERT_EQ(read.size(), x.size());
    if (x.size() == 0) continue;
    EXPECT_LT((read - x).cwiseAbs().maxCoeff(), 1e-12 * (1.0 + z.cwiseAbs().maxCoeff())) << s->name;
  }
}

TEST(ReducedUnknowns, ReachEverySeamlessMap) {
  // The solutions of (12) over all copies, by brute force: their dimension is the number of
  // unknowns, and no unknown is wasted.
  int compared = 0;
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    const int n = s->cut.vertexCount();
    if (n > 90) continue;
    std::vector<HalfedgeId> seam;
    for (EdgeId e : s->mesh.edges())
      if (s->cut.isSeam[e]) seam.push_back(s->mesh.halfedge(e));
    Eigen::MatrixXcd conditions = Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(seam.size()), n);
    for (int j = 0; j < n; ++j) {
      const Eigen::VectorXcd unit = Eigen::VectorXcd::Unit(n, j);
      for (std::size_t i = 0; i < seam.size(); ++i)
        conditions(static_cast<Eigen::Index>(i), j) = seamResidual(*s, seam[i], unit);
    }
    Eigen::Index rank = 0;
    if (!seam.empty()) {
      Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> qr(conditions);
      qr.setThreshold(1e-9);
      rank = qr.rank();
    }
    EXPECT_EQ(unknowns.count, n - rank) << s->name;
    Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> own{Eigen::MatrixXcd(unknowns.copies)};
    own.setThreshold(1e-9);
    EXPECT_EQ(own.rank(), unknowns.count) << s->name;
    ++compared;
  }
  EXPECT_GT(compared, 60);
}

TEST(ReducedUnknowns, ComposedTranslationsVanishAroundNonConeNodes) {
  std::mt19937 random(59);
  int nodes = 0;
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    const Eigen::VectorXcd z = unknowns.copies * randomVector(unknowns.count, random);
    for (VertexId v : s->mesh.vertices()) {
      if (!s->cut.isSeamNode[v] || s->mesh.isBoundary(v) || s->isCone(v)) continue;
      // Compose the maps across all seam edges at v, counterclockwise: p → R p + t.
      Complex R = 1.0, t = 0.0;
      for (HalfedgeId h : outgoingHalfedges(s->mesh, v)) {
        if (!s->cut.isSeam[s->mesh.edge(h)]) continue;
        const HalfedgeId right = s->mesh.twin(h);
        const Complex across = rotation(s->seams.rotation[right], s->seams.q);
        // Both sides of the edge at its head fix the translation.
        const Complex step = z[s->cut.copy[TriMesh::next(h)].i] - across * z[s->cut.copy[right].i];
        R = across * R;
        t = across * t + step;
      }
      EXPECT_LT(std::abs(R - 1.0), 1e-12) << s->name;
      EXPECT_LT(std::abs(t), 1e-11 * (1.0 + z.cwiseAbs().maxCoeff())) << s->name;
      ++nodes;
    }
  }
  EXPECT_GT(nodes, 30);
}

TEST(ReducedUnknowns, ConesAreDeterminedUnlessKIsAMultipleOfQ) {
  int whole = 0, determined = 0;
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    for (VertexId v : s->cones) {
      const bool isWhole = reduceTurn(s->k(v), s->seams.q) == 0;
      EXPECT_EQ(unknowns.vertexUnknown[v] >= 0, isWhole) << s->name << " k=" << s->k(v);
      ++(isWhole ? whole : determined);
    }
    for (VertexId v : s->mesh.vertices())
      if (!s->isCone(v)) {
        EXPECT_GE(unknowns.vertexUnknown[v], 0) << s->name;
      }
  }
  EXPECT_GT(whole, 2);
  EXPECT_GT(determined, 100);
}

TEST(ReducedUnknowns, TurnsCountFromTheFirstCopyThroughTheSeams) {
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    for (VertexId v : s->mesh.vertices()) {
      EXPECT_EQ(unknowns.turn[s->cut.firstCopy[v]], 0);
      for (HalfedgeId h : outgoingHalfedges(s->mesh, v)) {
        const HalfedgeId next = s->mesh.nextOutgoing(h);
        if (!next.isValid() || s->cut.copy[next] <= s->cut.copy[h]) continue;
        const int r = s->seams.rotation[s->mesh.twin(next)];
        EXPECT_EQ(unknowns.turn[s->cut.copy[next]],
                  reduceTurn(unknowns.turn[s->cut.copy[h]] + r, s->seams.q))
            << s->name;
      }
    }
  }
}

TEST(ReducedUnknowns, UnknownsAreTheValuesOfFirstCopiesAndTranslations) {
  std::mt19937 random(61);
  for (const auto& [s, unknowns] : reducedSurfaces()) {
    const Eigen::VectorXcd x = randomVector(unknowns.count, random);
    const Eigen::VectorXcd z = unknowns.copies * x;
    for (VertexId v : s->mesh.vertices())
      if (unknowns.vertexUnknown[v] >= 0) {
        EXPECT_LT(std::abs(z[s->cut.firstCopy[v].i] - x[unknowns.vertexUnknown[v]]), 1e-12);
      }
    for (std::size_t c = 0; c < s->cut.chains.size(); ++c) {
      if (unknowns.chainUnknown[c] < 0) continue;
      const HalfedgeId h = s->cut.chains[c].left[0];
      const Complex R = rotation(s->seams.rotation[h], s->seams.q);
      const Complex right = z[s->cut.copy[TriMesh::next(s->mesh.twin(h))].i];
      const Complex t = right - R * z[s->cut.copy[h].i];
      EXPECT_LT(std::abs(t - x[unknowns.chainUnknown[c]]), 1e-11 * (1.0 + z.cwiseAbs().maxCoeff()))
          << s->name;
    }
  }
}

TEST(ReducedUnknowns, BoundarySeamVerticesHaveFreeCopies) {
  // A vertex of degree d on the boundary has d + 1 copies and no closing condition: the first is
  // free, and so is one translation per seam edge unless another node decides it.
  int found = 0;
  for (const auto& [s, unknowns] : reducedSurfaces())
    for (VertexId v : s->mesh.vertices())
      if (s->mesh.isBoundary(v) && s->seamDegree(v) > 0) {
        EXPECT_GE(unknowns.vertexUnknown[v], 0) << s->name;
        EXPECT_TRUE(s->cut.isSeamNode[v]) << s->name;
        ++found;
      }
  EXPECT_GT(found, 30);
}

}  // namespace
}  // namespace hgp
