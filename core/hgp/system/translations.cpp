#include "hgp/system/translations.h"

#include <algorithm>
#include <map>
#include <set>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// Coefficients are sums of a few numbers of absolute value 1; a smaller one is a rounding error of 0.
constexpr double kCancelled = 1e-9;
/// Minimum size of a pivot relative to the row's largest coefficient, to limit rounding errors.
constexpr double kMinPivot = 0.3;

using Row = std::map<int, Complex>;

/// Gauss–Jordan with rows kept as maps and a column → rows index.
class Elimination {
 public:
  explicit Elimination(std::vector<TranslationSum> relations, int chainCount)
      : rows_(relations.size()), users_(static_cast<std::size_t>(chainCount)) {
    for (std::size_t r = 0; r < relations.size(); ++r)
      for (const TranslationTerm& t : relations[r]) add(static_cast<int>(r), t.chain, t.factor);
  }

  /// Solves all rows; returns chain → its row, −1 where the chain is free.
  std::vector<int> run() {
    std::vector<int> pivotRow(users_.size(), -1);
    std::set<std::pair<std::size_t, int>> open;
    for (int r = 0; r < static_cast<int>(rows_.size()); ++r) open.insert({row(r).size(), r});
    while (!open.empty()) {
      const int r = open.begin()->second;
      open.erase(open.begin());
      if (row(r).empty()) continue;
      const int chain = choosePivot(r);
      scale(r, portable::divide(1.0, row(r)[chain]));
      pivotRow[static_cast<std::size_t>(chain)] = r;
      const auto users = users_[static_cast<std::size_t>(chain)];
      for (int other : users) {
        if (other == r) continue;
        const bool isOpen = open.erase({row(other).size(), other}) > 0;
        const Complex factor = row(other)[chain];
        const Row source = row(r);
        for (const auto& [c, value] : source) add(other, c, -factor * value);
        if (isOpen) open.insert({row(other).size(), other});
      }
    }
    return pivotRow;
  }

  Row& row(int r) { return rows_[static_cast<std::size_t>(r)]; }

 private:
  void add(int r, int chain, Complex value) {
    Complex& entry = row(r)[chain];
    entry += value;
    if (portable::abs(entry) > kCancelled) {
      users_[static_cast<std::size_t>(chain)].insert(r);
    } else {
      row(r).erase(chain);
      users_[static_cast<std::size_t>(chain)].erase(r);
    }
  }
  int choosePivot(int r) {
    double largest = 0.0;
    for (const auto& [c, value] : row(r)) largest = std::max(largest, portable::abs(value));
    int best = -1;
    for (const auto& [c, value] : row(r)) {
      if (portable::abs(value) < kMinPivot * largest) continue;
      if (best < 0 || users_[static_cast<std::size_t>(c)].size() <
                          users_[static_cast<std::size_t>(best)].size())
        best = c;
    }
    return best;
  }
  void scale(int r, Complex factor) {
    for (auto& [c, value] : row(r)) value *= factor;
  }

  std::vector<Row> rows_;
  std::vector<std::set<int>> users_;
};

}  // namespace

std::vector<TranslationSum> solveTranslations(int chainCount,
                                              std::vector<TranslationSum> relations) {
  Elimination elimination(std::move(relations), chainCount);
  const std::vector<int> pivotRow = elimination.run();
  std::vector<TranslationSum> solved(static_cast<std::size_t>(chainCount));
  for (int c = 0; c < chainCount; ++c) {
    TranslationSum& sum = solved[static_cast<std::size_t>(c)];
    const int r = pivotRow[static_cast<std::size_t>(c)];
    if (r < 0) {
      sum.push_back({c, 1.0});
      continue;
    }
    for (const auto& [other, value] : elimination.row(r))
      if (other != c) sum.push_back({other, -value});
  }
  return solved;
}

}  // namespace hgp
