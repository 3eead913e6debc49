#include "hgp/system/square_rows.h"

#include <numeric>
#include <utility>

#include "hgp/base/ids.h"

namespace hgp {
namespace {

/// A sparse matrix by columns, or by rows; entries in any order.
template <class Scalar>
struct Lists {
  std::vector<int> start{0}, index;
  std::vector<Scalar> value;

  int count() const { return static_cast<int>(start.size()) - 1; }
  template <class Use>
  void forEach(int list, const Use& use) const {
    for (int e = start[at(list)]; e < start[at(list + 1)]; ++e) use(index[at(e)], value[at(e)]);
  }
};

template <class Scalar>
Lists<Scalar> transposed(const Lists<Scalar>& rows, int columns) {
  Lists<Scalar> out;
  out.start.assign(at(columns + 1), 0);
  for (const int j : rows.index) ++out.start[at(j + 1)];
  std::partial_sum(out.start.begin(), out.start.end(), out.start.begin());
  std::vector<int> next(out.start.begin(), out.start.end() - 1);
  out.index.resize(rows.index.size());
  out.value.resize(rows.index.size());
  for (int r = 0; r < rows.count(); ++r)
    rows.forEach(r, [&](int j, const Scalar& value) {
      const int to = next[at(j)]++;
      out.index[at(to)] = r;
      out.value[at(to)] = value;
    });
  return out;
}

/// The lower triangle of rowsᴴ rows by columns, each with its diagonal entry first.
template <class Scalar>
Lists<Scalar> lowerSquare(const Lists<Scalar>& rows, const Lists<Scalar>& columns) {
  Lists<Scalar> lower;
  std::vector<Scalar> sum(at(columns.count()), Scalar(0));
  std::vector<char> isListed(sum.size(), 0);
  const auto list = [&](int i) {
    if (!isListed[at(i)]) lower.index.push_back(i);
    isListed[at(i)] = 1;
  };
  lower.start.reserve(columns.start.size());
  for (int j = 0; j < columns.count(); ++j) {
    columns.forEach(j, [&](int row, const Scalar& factor) {
      list(j);
      rows.forEach(row, [&](int i, const Scalar& other) {
        if (i < j) return;
        list(i);
        sum[at(i)] += Eigen::numext::conj(other) * factor;
      });
    });
    for (std::size_t e = lower.value.size(); e < lower.index.size(); ++e) {
      lower.value.push_back(std::exchange(sum[at(lower.index[e])], Scalar(0)));
      isListed[at(lower.index[e])] = 0;
    }
    lower.start.push_back(static_cast<int>(lower.index.size()));
  }
  return lower;
}

/// The whole matrix. Appending column after column fills rows of the lower triangle in order, which are the columns of the upper
/// one, and these in turn the columns of the lower one.
template <class Scalar>
Eigen::SparseMatrix<Scalar> bothTriangles(const Lists<Scalar>& lower) {
  const int n = lower.count();
  Eigen::SparseMatrix<Scalar> out(n, n);
  std::vector<int> next(at(n), 0);
  for (int j = 0; j < n; ++j)
    lower.forEach(j, [&](int i, const Scalar&) {
      ++next[at(j)];
      if (i != j) ++next[at(i)];
    });
  out.resizeNonZeros(std::accumulate(next.begin(), next.end(), Eigen::Index{0}));
  int* const start = out.outerIndexPtr();
  for (int j = 0; j < n; ++j) start[j + 1] = start[j] + std::exchange(next[at(j)], start[j]);
  const auto append = [&](int column, int row, const Scalar& value) {
    const int to = next[at(column)]++;
    out.innerIndexPtr()[to] = row;
    out.valuePtr()[to] = value;
  };
  for (int j = 0; j < n; ++j)
    lower.forEach(j, [&](int i, const Scalar& value) {
      if (i != j) append(i, j, Eigen::numext::conj(value));
    });
  const std::vector<int> above = next;  // ends of the upper triangle
  for (int j = 0; j < n; ++j) {
    if (const auto own = at(lower.start[at(j)]); own < at(lower.start[at(j + 1)]))
      append(j, j, lower.value[own]);
    for (int e = start[j]; e < above[at(j)]; ++e)
      append(out.innerIndexPtr()[e], j, Eigen::numext::conj(out.valuePtr()[e]));
  }
  return out;
}

}  // namespace

template <class Scalar>
typename SquareRows<Scalar>::Form SquareRows<Scalar>::takeForm() {
  Lists<Scalar> lower;
  {
    const Lists<Scalar> rows = {std::move(start_), std::move(unknown_), std::move(factor_)};
    lower = lowerSquare(rows, transposed(rows, static_cast<int>(linear.size())));
  }
  return bothTriangles(lower);
}

template class SquareRows<double>;
template class SquareRows<std::complex<double>>;

}  // namespace hgp
