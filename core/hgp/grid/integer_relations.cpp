#include "hgp/grid/integer_relations.h"

#include <algorithm>
#include <map>
#include <set>

namespace hgp {
namespace {

constexpr std::int64_t kLargestNorm = std::int64_t{1} << 60;

using Row = std::map<int, Gaussian>;

/// The relations as rows, and the original variables in terms of the current ones, also as rows.
class Elimination {
 public:
  Elimination(int count, const std::vector<GaussianSum>& relations)
      : rows_(relations.size()), users_(static_cast<std::size_t>(count)) {
    for (std::size_t r = 0; r < relations.size(); ++r)
      for (const GaussianTerm& t : relations[r]) add(static_cast<int>(r), t.variable, t.factor);
    value_.resize(static_cast<std::size_t>(count));
    coordinate_.resize(static_cast<std::size_t>(count));
    for (int v = 0; v < count; ++v) value_[at(v)][v] = coordinate_[at(v)][v] = Gaussian{1, 0};
    pivotRow_.assign(static_cast<std::size_t>(count), -1);
  }

  bool run() {
    std::set<std::pair<std::size_t, int>> open;
    for (int r = 0; r < static_cast<int>(rows_.size()); ++r) open.insert({row(r).size(), r});
    while (!open.empty() && isSmall_) {
      const int r = open.begin()->second;
      open.erase(open.begin());
      if (row(r).empty()) continue;
      divideByContent(r);
      int pivot = unitOf(r);
      if (pivot < 0) pivot = euclid(r, open);
      const Gaussian inverse = conjugate(row(r)[pivot]);  // the inverse of a unit
      for (auto& [v, factor] : row(r)) factor = factor * inverse;
      pivotRow_[at(pivot)] = r;
      const std::set<int> users = users_[at(pivot)];
      for (int other : users)
        if (other != r) subtract(other, row(other)[pivot], r, open);
    }
    return isSmall_;
  }

  IntegerBasis take() {
    IntegerBasis basis;
    std::vector<int> name(users_.size(), -1);
    for (std::size_t v = 0; v < users_.size(); ++v) {
      if (pivotRow_[v] >= 0) continue;
      name[v] = basis.size();
      basis.coordinate.push_back(sumOf(coordinate_[v]));
    }
    for (const Row& expression : value_) {
      Row free;
      for (const auto& [v, factor] : expression) {
        if (pivotRow_[at(v)] < 0) {
          addTo(free, name[at(v)], factor);
          continue;
        }
        for (const auto& [other, share] : row(pivotRow_[at(v)]))
          if (other != v) addTo(free, name[at(other)], -(factor * share));
      }
      basis.value.push_back(sumOf(free));
    }
    return basis;
  }

 private:
  Row& row(int r) { return rows_[at(r)]; }

  static GaussianSum sumOf(const Row& row) {
    GaussianSum sum;
    for (const auto& [v, factor] : row) sum.push_back({v, factor});
    return sum;
  }
  static void addTo(Row& row, int v, Gaussian factor) {
    Gaussian& entry = row[v];
    entry = entry + factor;
    if (isZero(entry)) row.erase(v);
  }
  void add(int r, int v, Gaussian factor) {
    Gaussian& entry = row(r)[v];
    entry = entry + factor;
    isSmall_ = isSmall_ && norm(entry) < kLargestNorm;
    if (isZero(entry)) {
      row(r).erase(v);
      users_[at(v)].erase(r);
    } else {
      users_[at(v)].insert(r);
    }
  }
  /// row(target) −= factor · row(source)
  void subtract(int target, Gaussian factor, int source,
                std::set<std::pair<std::size_t, int>>& open) {
    const bool isOpen = open.erase({row(target).size(), target}) > 0;
    const Row copied = row(source);
    for (const auto& [v, share] : copied) add(target, v, -(factor * share));
    if (isOpen) open.insert({row(target).size(), target});
  }

  void divideByContent(int r) {
    Gaussian content;
    for (const auto& [v, factor] : row(r)) content = commonDivisor(content, factor);
    if (isUnit(content)) return;
    for (auto& [v, factor] : row(r)) factor = exactQuotient(factor, content);
  }

  /// The variable with a unit coefficient that occurs in the fewest other rows; −1 if there is none.
  int unitOf(int r) {
    int best = -1;
    for (const auto& [v, factor] : row(r))
      if (isUnit(factor) && (best < 0 || users_[at(v)].size() < users_[at(best)].size())) best = v;
    return best;
  }

  /// Changes variables until the row has a unit: with a·x + b·y and q ≈ b/a, the substitution x = x' − q·y gives
  /// a·x' + (b − q·a)·y. By Euclid's algorithm, a row with content 1 ends up with a unit.
  int euclid(int r, std::set<std::pair<std::size_t, int>>& open) {
    while (isSmall_) {
      const int found = unitOf(r);
      if (found >= 0) return found;
      int smallest = -1;
      for (const auto& [v, factor] : row(r))
        if (smallest < 0 || norm(factor) < norm(row(r)[smallest])) smallest = v;
      const Gaussian a = row(r)[smallest];
      const Row copied = row(r);
      for (const auto& [v, factor] : copied)
        if (v != smallest) substitute(smallest, v, nearestQuotient(factor, a), open);
    }
    return row(r).begin()->first;
  }

  /// Substitutes x = x' − q·y everywhere.
  void substitute(int x, int y, Gaussian q, std::set<std::pair<std::size_t, int>>& open) {
    if (isZero(q)) return;
    const std::set<int> users = users_[at(x)];
    for (int other : users) {
      const bool isOpen = open.erase({row(other).size(), other}) > 0;
      add(other, y, -(row(other)[x] * q));
      if (isOpen) open.insert({row(other).size(), other});
    }
    for (Row& expression : value_) {
      const auto it = expression.find(x);
      if (it != expression.end()) addTo(expression, y, -(it->second * q));
    }
    for (const auto& [v, factor] : Row(coordinate_[at(y)]))  // x' = x + q·y
      addTo(coordinate_[at(x)], v, q * factor);
  }

  std::vector<Row> rows_;
  std::vector<std::set<int>> users_;
  std::vector<Row> value_, coordinate_;
  std::vector<int> pivotRow_;
  bool isSmall_ = true;
};

}  // namespace

std::optional<IntegerBasis> solveRelations(int variableCount,
                                           const std::vector<GaussianSum>& relations) {
  Elimination elimination(variableCount, relations);
  if (!elimination.run()) return {};
  return elimination.take();
}

}  // namespace hgp
