#include "hgp/system/row_builder.h"

#include <algorithm>

#include "hgp/base/portable_math.h"

namespace hgp {

RowBuilder::RowBuilder(int columns, int expectedRows, std::size_t expectedEntries)
    : index_(static_cast<std::size_t>(columns), 0) {
  start_.reserve(static_cast<std::size_t>(expectedRows) + 1);
  column_.reserve(expectedEntries);
  value_.reserve(expectedEntries);
}

void RowBuilder::add(int column, const Complex& value) {
  int& index = index_[static_cast<std::size_t>(column)];
  const auto at = static_cast<std::size_t>(index);
  if (at < row_.size() && row_[at].column == column) {
    row_[at].value += value;
    return;
  }
  index = static_cast<int>(row_.size());
  row_.push_back({column, value});
}

void RowBuilder::endRow(double noise) {
  std::sort(row_.begin(), row_.end(),
            [](const Term& a, const Term& b) { return a.column < b.column; });
  for (const Term& t : row_) {
    if (!(portable::abs(t.value) > noise)) continue;
    column_.push_back(t.column);
    value_.push_back(t.value);
  }
  start_.push_back(static_cast<int>(column_.size()));
  row_.clear();
}

SparseRows RowBuilder::take() {
  const auto count = static_cast<Eigen::Index>(column_.size());
  SparseRows rows = Eigen::Map<const SparseRows>(static_cast<Eigen::Index>(start_.size()) - 1,
                                                 static_cast<Eigen::Index>(index_.size()), count,
                                                 start_.data(), column_.data(), value_.data());
  start_.assign(1, 0);
  column_ = {};
  value_ = {};
  return rows;
}

}  // namespace hgp
