// Sums of squares of rows.  Law: the form is the sum; its columns are sorted, and its triangles conjugates to the last bit.
#include "hgp/system/square_rows.h"

#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

namespace hgp {
namespace {

using Complex = std::complex<double>;

double draw(std::mt19937& random) {
  return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
}

template <class Scalar>
Scalar scalar(std::mt19937& random) {
  if constexpr (std::is_same_v<Scalar, double>)
    return draw(random);
  else
    return {draw(random), draw(random)};
}

/// Rows that mention some of five unknowns, one of them twice, and one row that mentions none.
template <class Scalar>
void expectSumOfSquares() {
  std::mt19937 random(7);
  SquareRows<Scalar> sum(5);
  std::vector<std::pair<std::vector<std::pair<int, Scalar>>, Scalar>> rows;
  for (const std::vector<int>& unknowns : {std::vector<int>{0, 3}, {}, {4, 1, 4}, {2}, {3, 0, 1}}) {
    auto& [terms, constant] = rows.emplace_back();
    for (const int unknown : unknowns) {
      terms.emplace_back(unknown, scalar<Scalar>(random));
      sum.add(unknown, terms.back().second);
    }
    constant = scalar<Scalar>(random);
    sum.endRow(constant);
  }
  const typename SquareRows<Scalar>::Vector linear = sum.linear;
  const Eigen::SparseMatrix<Scalar> H = sum.takeForm();
  typename SquareRows<Scalar>::Vector x(5);
  for (Eigen::Index i = 0; i < 5; ++i) x[i] = scalar<Scalar>(random);
  double squares = 0.0, atZero = 0.0;
  for (const auto& [terms, constant] : rows) {
    Scalar value = constant;
    for (const auto& [unknown, factor] : terms) value += factor * x[unknown];
    squares += std::norm(value);
    atZero += std::norm(constant);
  }
  ASSERT_TRUE(H.isCompressed());
  for (int j = 0; j < 5; ++j)
    for (typename Eigen::SparseMatrix<Scalar>::InnerIterator it(H, j), before(H, j); it; ++it) {
      if (it.row() != before.row()) {
        EXPECT_LT(before.row(), it.row()) << "column " << j;
        ++before;
      }
      EXPECT_EQ(H.coeff(j, it.row()), Eigen::numext::conj(it.value())) << it.row() << ", " << j;
    }
  EXPECT_EQ(H.nonZeros(), 13) << "the pairs that rows mention";
  const double form = std::real(x.dot(H * x)) + 2.0 * std::real(linear.dot(x)) + atZero;
  EXPECT_NEAR(form, squares, 1e-14);
}

TEST(SquareRows, AreTheSumOfTheSquaresOfTheirRows) {
  expectSumOfSquares<double>();
  expectSumOfSquares<Complex>();
}

}  // namespace
}  // namespace hgp
