// Frame conditions on changes of a map.  Laws: without any the minimiser is that of the sum of squares; with conditions it
// fulfils them, however far the sum pulls; of two targets that contradict each other there is no minimiser.
#include "hgp/parametrize/live/frame_conditions.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "solved_map.h"

namespace hgp::live {
namespace {

/// The unknowns around one vertex of a certified map, numbered.
struct Patch : test_support::SolvedMap {
  Patch() : SolvedMap(test::jittered(test::icosphere(6), 0.01)) {
    index.assign(at(setup.unknowns.count), -1);
    VertexId centre(0);
    while (setup.unknowns.vertexUnknown[centre] < 0) ++centre.i;
    for (HalfedgeId h : outgoingHalfedges(mesh, centre)) {
      faces.push_back(TriMesh::face(h));
      for (int k = 0; k < 3; ++k)
        for (const Term& t : cut->termsOf(TriMesh::halfedge(faces.back(), k)))
          if (index[at(t.unknown)] < 0) index[at(t.unknown)] = count++;
    }
  }

  /// Σ |δ − pull|².
  SumOfSquares sumTowards(const Eigen::VectorXcd& pull) const {
    SumOfSquares sum(at(count));
    sum.H.setIdentity();
    sum.c = -pull;
    return sum;
  }
  FrameConditions conditions() const { return {setup.context->geometry, *cut, index}; }
  FaceTerms termsOf(FaceId f) const { return faceTerms(setup.context->geometry, *cut, f); }
  Eigen::VectorXcd after(const Eigen::VectorXcd& change) const {
    Eigen::VectorXcd out = x;
    for (Eigen::Index i = 0; i < out.size(); ++i)
      if (index[at(i)] >= 0) out[i] += change[index[at(i)]];
    return out;
  }

  std::vector<int> index;
  std::vector<FaceId> faces;
  int count = 0;
};

TEST(FrameConditions, WithoutAnyTheMinimiserIsThatOfTheSum) {
  const Patch patch;
  const Eigen::VectorXcd pull = Eigen::VectorXcd::Random(patch.count);
  EXPECT_LT((patch.conditions().minimise(patch.sumTowards(pull)) - pull).norm(), 1e-12);
}

TEST(FrameConditions, HoldHoweverFarTheSumPulls) {
  const Patch patch;
  for (const double far : {0.0, 1.0, 100.0})
    for (const double size : {0.2, 1.0, 20.0}) {  // of the map that the targets are of
      const auto target = [&](FaceId f) {
        return size * valueOf(patch.termsOf(f).similar, patch.x);
      };
      FrameConditions conditions = patch.conditions();
      for (FaceId f : patch.faces) conditions.add(f, target(f), patch.x);
      const Eigen::VectorXcd pull = far * Eigen::VectorXcd::Random(patch.count);
      const Eigen::VectorXcd change = conditions.minimise(patch.sumTowards(pull));
      ASSERT_EQ(change.size(), patch.count);
      const Eigen::VectorXcd x = patch.after(change);
      for (FaceId f : patch.faces) {
        const FaceTerms terms = patch.termsOf(f);
        const double length = std::abs(target(f));
        const Complex along = valueOf(terms.similar, x) * std::conj(target(f)) / length;
        EXPECT_GE(along.real() - std::abs(valueOf(terms.anti, x)), 0.049 * length);
      }
    }
}

TEST(FrameConditions, OpposedTargetsOfATriangleHaveNoMinimiser) {
  const Patch patch;
  FrameConditions conditions = patch.conditions();
  conditions.add(patch.faces.front(), 1.0, patch.x);
  conditions.add(patch.faces.front(), -1.0, patch.x);
  EXPECT_EQ(conditions.minimise(patch.sumTowards(Eigen::VectorXcd::Zero(patch.count))).size(), 0);
}

TEST(FrameConditions, TrianglesWithoutNumbersAreLeftOut) {
  Patch patch;
  patch.index.assign(patch.index.size(), -1);
  FrameConditions conditions = patch.conditions();
  conditions.add(patch.faces.front(), 1.0, patch.x);
  EXPECT_EQ(conditions.minimise(patch.sumTowards(Eigen::VectorXcd::Zero(patch.count))).size(),
            patch.count);
}

}  // namespace
}  // namespace hgp::live
