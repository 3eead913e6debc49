#include "hgp/system/row_builder.h"

#include <algorithm>

#include "hgp/base/portable_math.h"

namespace hgp {

RowBuilder::RowBuilder(int columns, int expectedRows, std::size_t expectedEntries)
    : index_(static_cast<std::size_t>(columns), 0) {
  start_.reserve(static_cast<std::size_t>(expectedRows) + 1);
  entries_.reserve(static_cast<Eigen::Index>(expectedEntries));
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
    entries_.append(t.value, t.column);
  }
  start_.push_back(static_cast<int>(entries_.size()));
  row_.clear();
}

SparseRows RowBuilder::take() {
  SparseRows rows(static_cast<Eigen::Index>(start_.size()) - 1,
                  static_cast<Eigen::Index>(index_.size()));
  std::copy(start_.begin(), start_.end(), rows.outerIndexPtr());
  rows.data().swap(entries_);
  start_.assign(1, 0);
  return rows;
}

}  // namespace hgp
