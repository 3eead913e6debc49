#include "hgp/features/sum_lattice.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hgp/base/ids.h"

namespace hgp {
namespace {

constexpr std::int64_t kLargestStep = std::int64_t{1} << 40;

}  // namespace

/// row − times · other; false where integers grow beyond what is exact: row is then of no use.
bool SumLattice::subtract(Row& row, const Row& other, std::int64_t times) {
  for (const auto& [variable, step] : other) {
    std::int64_t& entry = row[variable];
    if (std::abs(step) > 2 * kLargestStep / std::max<std::int64_t>(1, std::abs(times)))
      return false;  // the product is not computed: it may exceed the integers
    entry -= times * step;
    if (std::abs(entry) > kLargestStep) return false;
    if (entry == 0) row.erase(variable);
  }
  return true;
}

bool SumLattice::add(const RealSum& sum) {
  Row row;
  for (const auto& [variable, factor] : sum) row[variable] = std::llround(kFactorSteps * factor);
  while (!row.empty()) {
    const int first = row.begin()->first;
    const auto found = rows_.find(first);
    if (found == rows_.end()) {
      rows_[first] = std::move(row);
      return true;
    }
    Row& own = found->second;
    // Euclid's algorithm on the first factors.
    while (!row.empty() && row.begin()->first == first) {
      const std::int64_t times = row.at(first) / own.at(first);
      if (!subtract(row, own, times)) return false;
      if (!row.empty() && row.begin()->first == first) std::swap(row, own);
    }
    // Every step doubles the other factors otherwise.
    shorten(row, first);
    shorten(own, first);
  }
  return true;
}

bool SumLattice::isComplete() const {
  return std::all_of(rows_.begin(), rows_.end(), [&](const auto& named) {
    return std::all_of(named.second.begin(), named.second.end(),
                       [&](const auto& term) { return rows_.contains(term.first); });
  });
}

std::vector<int> SumLattice::variables() const {
  std::vector<int> out;
  for (const auto& [variable, row] : rows_) out.push_back(variable);
  return out;
}

void SumLattice::shorten(Row& row, int first) const {
  for (auto later = rows_.upper_bound(first); later != rows_.end(); ++later) {
    const auto entry = row.find(later->first);
    if (entry == row.end()) continue;
    const std::int64_t pivot = later->second.at(later->first);
    const std::int64_t times =
        std::llround(static_cast<double>(entry->second) / static_cast<double>(pivot));
    // Where integers would grow too large the row stays as it is, which generates the same sums.
    if (Row reduced = row; times != 0 && subtract(reduced, later->second, times))
      row = std::move(reduced);
  }
}

void SumLattice::reduce() {
  for (auto own = rows_.rbegin(); own != rows_.rend(); ++own) shorten(own->second, own->first);
}

Eigen::MatrixXd SumLattice::basis() const {
  const std::vector<int> order = variables();
  const auto n = static_cast<Eigen::Index>(order.size());
  Eigen::MatrixXd B = Eigen::MatrixXd::Zero(n, n);
  Eigen::Index i = 0;
  for (const auto& [first, row] : rows_) {
    for (const auto& [variable, step] : row) {
      const auto j = std::lower_bound(order.begin(), order.end(), variable) - order.begin();
      B(i, j) = static_cast<double>(step) / kFactorSteps;
    }
    ++i;
  }
  return B;
}

}  // namespace hgp
