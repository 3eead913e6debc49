// f_z and f_z̄ over unknowns.  Laws: they are those of the map, whatever is held; a condition holds exactly where its
// cone does; the quadratic form of squares is their sum.
#include "hgp/system/face_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "hgp/system/reduced_unknowns.h"
#include "support/seamless.h"

namespace hgp {
namespace {

Eigen::VectorXcd anyVector(Eigen::Index size, std::mt19937& random) {
  Eigen::VectorXcd x(size);
  for (Complex& value : x) value = {test::randomReal(random), test::randomReal(random)};
  return x;
}

struct RowsOfFace {
  FaceRows rows;
  Complex similar, anti;  ///< of the map, from its corners
};

/// The rows of all triangles of a few surfaces with random unknowns, a third of them held, and what they must give.
template <class Check>
void forRandomRows(Check check) {
  std::mt19937 random(71);
  int seen = 0;
  for (const test::CutSurface& s : test::cutSurfaces()) {
    if (++seen % 7 != 0) continue;
    const ReducedUnknowns unknowns = reduceUnknowns(s.mesh, s.cut, s.seams);
    const Eigen::VectorXcd x = anyVector(unknowns.count, random), z = unknowns.copies * x;
    std::vector<char> isHeld(at(unknowns.count));
    for (char& held : isHeld) held = test::randomBelow(random, 3) == 0;
    const FreeUnknowns free(isHeld);
    const Eigen::VectorXcd y = free.gather(x);
    for (FaceId f : s.mesh.faces()) {
      RowsOfFace of;
      const LinearParts parts = linearParts(s.context.geometry, f);
      gatherFaceRows(
          parts, CornerCopies{s.cut, unknowns, f}, [&](int i) { return free.number(i); }, x,
          of.rows);
      for (int k = 0; k < 3; ++k) {
        const Complex corner = z[s.cut.copy[TriMesh::halfedge(f, k)].i];
        of.similar += parts.similarity[at(k)] * corner;
        of.anti += parts.antisimilarity[at(k)] * corner;
      }
      check(of, y, random);
    }
  }
}

Complex similarAt(const FaceRows& rows, const Eigen::VectorXcd& y) {
  Complex sum = rows.heldSimilar;
  for (const FaceRows::Term& term : rows.terms) sum += term.similar * y[term.unknown];
  return sum;
}
Complex antiAt(const FaceRows& rows, const Eigen::VectorXcd& y) {
  Complex sum = rows.heldAnti;
  for (const FaceRows::Term& term : rows.terms) sum += term.anti * y[term.unknown];
  return sum;
}

TEST(FaceRows, AreThoseOfTheMapWhateverIsHeld) {
  int withHeld = 0, withoutFree = 0;
  forRandomRows([&](const RowsOfFace& of, const Eigen::VectorXcd& y, std::mt19937&) {
    const double size = 1e-11 * (1.0 + std::abs(of.similar) + std::abs(of.anti));
    EXPECT_LT(std::abs(similarAt(of.rows, y) - of.similar), size);
    EXPECT_LT(std::abs(antiAt(of.rows, y) - of.anti), size);
    std::vector<int> unknowns = of.rows.unknowns();
    std::sort(unknowns.begin(), unknowns.end());
    EXPECT_TRUE(std::adjacent_find(unknowns.begin(), unknowns.end()) == unknowns.end());
    withHeld += of.rows.heldSimilar != Complex(0.0);
    withoutFree += of.rows.terms.empty();
  });
  EXPECT_GT(withHeld, 100);
  EXPECT_GT(withoutFree, 5);
}

TEST(FaceRows, TheConditionIsTheConeOfTheTurnedMap) {
  forRandomRows([&](const RowsOfFace& of, const Eigen::VectorXcd& y, std::mt19937& random) {
    const Complex turn = std::polar(1.7, test::randomReal(random));
    const socp::ConeConstraint condition = coneCondition(of.rows, turn, 0.6, 0.25);
    Eigen::VectorXd reals(2 * static_cast<Eigen::Index>(of.rows.terms.size()));
    Eigen::Index n = 0;
    for (const FaceRows::Term& term : of.rows.terms) {
      reals[n++] = y[term.unknown].real();
      reals[n++] = y[term.unknown].imag();
    }
    Eigen::Vector3d s = -condition.h;
    if (n > 0) s += condition.F * reals;
    const double size = 1e-11 * (1.0 + std::abs(of.similar) + std::abs(of.anti));
    EXPECT_NEAR(s[0], (turn * of.similar).real() - 0.25, size);
    EXPECT_NEAR(s[1], 0.6 * of.anti.real(), size);
    EXPECT_NEAR(s[2], 0.6 * of.anti.imag(), size);
  });
}

TEST(FaceRows, SquaresAreTheQuadraticFormUpToWhatIsHeld) {
  forRandomRows([&](const RowsOfFace& of, const Eigen::VectorXcd& y, std::mt19937&) {
    double form = 0.0;
    addSquares(
        of.rows, 0.3, 2.0,
        [&](int i, const Complex& c) { form += 2.0 * (std::conj(c) * y[i]).real(); },
        [&](int i, int j, const Complex& h) { form += (std::conj(y[i]) * h * y[j]).real(); });
    const double held = 0.3 * std::norm(of.rows.heldSimilar) + 2.0 * std::norm(of.rows.heldAnti);
    const double squares = 0.3 * std::norm(of.similar) + 2.0 * std::norm(of.anti);
    EXPECT_NEAR(form + held, squares, 1e-9 * (1.0 + squares + held));
  });
}

TEST(FaceRows, ScalingMultipliesEverything) {
  forRandomRows([&](const RowsOfFace& of, const Eigen::VectorXcd& y, std::mt19937&) {
    FaceRows scaled = of.rows;
    const Complex turn(0.4, -1.2);
    scaled.scale(turn, 3.0);
    const double size = 1e-10 * (1.0 + std::abs(of.similar) + std::abs(of.anti));
    EXPECT_LT(std::abs(similarAt(scaled, y) - turn * of.similar), size);
    EXPECT_LT(std::abs(antiAt(scaled, y) - 3.0 * of.anti), size);
  });
}

TEST(LinearParts, OfALinearMapAreItsOwn) {
  // f(w) = αw + βw̄ + γ has f_z = α and f_z̄ = β on every triangle.
  std::mt19937 random(5);
  for (int n = 0; n < 20; ++n) {
    const Eigen::VectorXcd w = anyVector(3, random), of = anyVector(3, random);
    const std::array<Complex, 3> corner{w[0], w[1], w[2]};
    const double twiceArea = std::imag(std::conj(w[1] - w[0]) * (w[2] - w[0]));
    const LinearParts parts = linearParts(corner, twiceArea);
    Complex similar = 0.0, anti = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Complex value = of[0] * corner[k] + of[1] * std::conj(corner[k]) + of[2];
      similar += parts.similarity[k] * value;
      anti += parts.antisimilarity[k] * value;
    }
    const double rounding = 1e-14 / std::abs(twiceArea);
    EXPECT_LT(std::abs(similar - of[0]), rounding);
    EXPECT_LT(std::abs(anti - of[1]), rounding);
  }
}

TEST(FreeUnknowns, OfAListAreNumberedInItsOrderOnceEach) {
  const FreeUnknowns free({4, 1, 4, 2}, 6);
  EXPECT_EQ(free.unknownOf(), (std::vector<int>{4, 1, 2}));
  for (int n = 0; n < free.count(); ++n) EXPECT_EQ(free.number(free.unknownOf()[at(n)]), n);
  for (const int held : {0, 3, 5}) EXPECT_EQ(free.number(held), -1);
}

TEST(FreeUnknowns, AreNumberedInTheirOrderAndGoThereAndBack) {
  const FreeUnknowns free({0, 1, 0, 0, 1});
  EXPECT_EQ(free.count(), 3);
  EXPECT_EQ(free.unknownOf(), (std::vector<int>{0, 2, 3}));
  EXPECT_EQ(free.number(1), -1);
  EXPECT_EQ(free.number(3), 2);
  Eigen::VectorXcd x(5), changed = Eigen::VectorXcd::Constant(5, 9.0);
  x << 1.0, 2.0, 3.0, 4.0, 5.0;
  free.scatter(free.gather(x), changed);
  Eigen::VectorXcd expected(5);
  expected << 1.0, 9.0, 3.0, 4.0, 9.0;
  EXPECT_EQ(changed, expected);
}

}  // namespace
}  // namespace hgp
