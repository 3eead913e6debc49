#include "hgp/seams/relations.h"

#include <algorithm>
#include <map>
#include <set>

#include "hgp/base/check.h"

namespace hgp {
namespace {

constexpr std::int64_t kLargestNorm = std::int64_t{1} << 60;

/// The relations as rows, with an index of the rows that use a variable.
template <class Ring>
class RelationRows {
 public:
  using Row = std::map<int, Ring>;

  RelationRows(int count, const std::vector<RingSum<Ring>>& relations)
      : rows_(relations.size()), users_(at(count)), pivotRow_(at(count), -1) {
    for (std::size_t r = 0; r < relations.size(); ++r)
      for (const RingTerm<Ring>& t : relations[r]) add(static_cast<int>(r), t.variable, t.factor);
    for (int r = 0; r < static_cast<int>(rows_.size()); ++r) open_.insert({row(r).size(), r});
  }

  /// Gauss–Jordan, shortest row first.
  /// @param pivotWithoutUnit  called with a row that has no unit; returns its pivot
  /// @return false where a coefficient became too large
  template <class Pivot>
  bool run(Pivot pivotWithoutUnit) {
    while (!open_.empty() && isSmall_) {
      const int r = open_.begin()->second;
      open_.erase(open_.begin());
      if (row(r).empty()) continue;
      divideByContent(r);
      int pivot = unitOf(r);
      if (pivot < 0) pivot = pivotWithoutUnit(r);
      const Ring leading = row(r)[pivot];
      if (isUnit(leading))
        for (auto& [v, factor] : row(r)) factor = factor * conjugate(leading);
      pivotRow_[at(pivot)] = r;
      const std::set<int> users = users_[at(pivot)];
      for (int other : users)
        if (other != r) eliminate(other, pivot, r);
    }
    return isSmall_;
  }

  /// The same, where a row without a unit is divided by the coefficient of its least used variable.
  bool run() {
    return run([this](int r) { return leastUsed(r); });
  }

  Row& row(int r) { return rows_[at(r)]; }
  bool isSmall() const { return isSmall_; }
  int variableCount() const { return static_cast<int>(pivotRow_.size()); }
  /// The row that determines the variable, −1 where it is free.
  int pivotRow(int v) const { return pivotRow_[at(v)]; }

  /// The variable that occurs in the fewest other rows, of those with a unit coefficient; −1 if there is none.
  int unitOf(int r) { return leastUsed(r, true); }
  int leastUsed(int r) { return leastUsed(r, false); }

  /// Substitutes x = x' − q·y in every row.
  void substitute(int x, int y, const Ring& q) {
    const std::set<int> users = users_[at(x)];
    for (int other : users) change(other, [&] { add(other, y, -(row(other)[x] * q)); });
  }

 private:
  int leastUsed(int r, bool isUnitNeeded) {
    int best = -1;
    for (const auto& [v, factor] : row(r))
      if ((!isUnitNeeded || isUnit(factor)) &&
          (best < 0 || users_[at(v)].size() < users_[at(best)].size()))
        best = v;
    return best;
  }
  void add(int r, int v, const Ring& factor) {
    Ring& entry = row(r)[v];
    entry = entry + factor;
    isSmall_ = isSmall_ && norm(entry) < kLargestNorm;
    if (isZero(entry)) {
      row(r).erase(v);
      users_[at(v)].erase(r);
    } else {
      users_[at(v)].insert(r);
    }
  }
  /// Changes a row and keeps its place in the order of lengths.
  template <class Change>
  void change(int r, Change apply) {
    const bool isOpen = open_.erase({row(r).size(), r}) > 0;
    apply();
    if (isOpen) open_.insert({row(r).size(), r});
  }
  /// Adds a multiple of the row `source` to `target`, times the pivot's coefficient if that is no unit.
  void eliminate(int target, int pivot, int source) {
    change(target, [&] {
      const Ring factor = row(target)[pivot];
      const Row copied = row(source);
      const Ring& leading = copied.at(pivot);
      if (!isUnit(leading))
        for (auto& [v, own] : row(target)) own = own * leading;
      for (const auto& [v, share] : copied) add(target, v, -(factor * share));
    });
  }

  void divideByContent(int r) {
    if constexpr (Ring::kIsEuclidean) {
      Ring content{};
      for (const auto& [v, factor] : row(r)) content = commonDivisor(content, factor);
      if (isUnit(content)) return;
      for (auto& [v, factor] : row(r)) factor = exactQuotient(factor, content);
    }
  }

  std::vector<Row> rows_;
  std::vector<std::set<int>> users_;
  std::vector<int> pivotRow_;
  std::set<std::pair<std::size_t, int>> open_;
  bool isSmall_ = true;
};

template <class Ring>
using RowOf = typename RelationRows<Ring>::Row;

template <class Ring>
RingSum<Ring> sumOf(const RowOf<Ring>& row) {
  RingSum<Ring> sum;
  for (const auto& [v, factor] : row) sum.push_back({v, factor});
  return sum;
}

template <class Ring>
void addTo(RowOf<Ring>& row, int v, const Ring& factor) {
  Ring& entry = row[v];
  entry = entry + factor;
  if (isZero(entry)) row.erase(v);
}

/// The elimination with changes of variables, which keeps the original ones in terms of the current ones and back.
template <class Ring>
class LatticeElimination {
 public:
  LatticeElimination(int count, const std::vector<RingSum<Ring>>& relations)
      : rows_(count, relations), value_(at(count)), coordinate_(at(count)) {
    for (int v = 0; v < count; ++v) value_[at(v)][v] = coordinate_[at(v)][v] = Ring::turned(0);
  }

  bool run() {
    return rows_.run([this](int r) { return euclid(r); });
  }

  LatticeBasis<Ring> take() {
    LatticeBasis<Ring> basis;
    std::vector<int> name(value_.size(), -1);
    for (std::size_t v = 0; v < name.size(); ++v) {
      if (rows_.pivotRow(static_cast<int>(v)) >= 0) continue;
      name[v] = basis.size();
      basis.coordinate.push_back(sumOf<Ring>(coordinate_[v]));
    }
    for (const auto& expression : value_) {
      RowOf<Ring> free;
      for (const auto& [v, factor] : expression) {
        if (rows_.pivotRow(v) < 0) {
          addTo(free, name[at(v)], factor);
          continue;
        }
        for (const auto& [other, share] : rows_.row(rows_.pivotRow(v)))
          if (other != v) addTo(free, name[at(other)], -(factor * share));
      }
      basis.value.push_back(sumOf<Ring>(free));
    }
    return basis;
  }

 private:
  /// Changes variables until the row has a unit: with a·x + b·y and q ≈ b/a, the substitution x = x' − q·y gives
  /// a·x' + (b − q·a)·y. By Euclid's algorithm, a row with content 1 ends up with a unit.
  int euclid(int r) {
    while (rows_.isSmall()) {
      const int found = rows_.unitOf(r);
      if (found >= 0) return found;
      int smallest = -1;
      for (const auto& [v, factor] : rows_.row(r))
        if (smallest < 0 || norm(factor) < norm(rows_.row(r)[smallest])) smallest = v;
      const Ring a = rows_.row(r)[smallest];
      const RowOf<Ring> copied = rows_.row(r);
      for (const auto& [v, factor] : copied)
        if (v != smallest) substitute(smallest, v, nearestQuotient(factor, a));
    }
    return rows_.row(r).begin()->first;
  }

  /// Substitutes x = x' − q·y everywhere.
  void substitute(int x, int y, const Ring& q) {
    if (isZero(q)) return;
    rows_.substitute(x, y, q);
    for (auto& expression : value_) {
      const auto it = expression.find(x);
      if (it != expression.end()) addTo(expression, y, -(it->second * q));
    }
    const RowOf<Ring> copied = coordinate_[at(y)];
    for (const auto& [v, factor] : copied)
      addTo(coordinate_[at(x)], v, q * factor);  // x' = x + q·y
  }

  RelationRows<Ring> rows_;
  std::vector<RowOf<Ring>> value_, coordinate_;
};

}  // namespace

template <class Ring>
FreeVariables<Ring> eliminateRelations(int variableCount,
                                       const std::vector<RingSum<Ring>>& relations) {
  RelationRows<Ring> rows(variableCount, relations);
  const bool isExact = rows.run();
  HGP_CHECK(isExact, "coefficients of relations between translations stay small");
  FreeVariables<Ring> out;
  for (int v = 0; v < variableCount; ++v) {
    typename FreeVariables<Ring>::Value& value = out.value.emplace_back();
    out.isFree.push_back(rows.pivotRow(v) < 0);
    if (rows.pivotRow(v) < 0) continue;
    for (const auto& [other, factor] : rows.row(rows.pivotRow(v))) {
      if (other != v)
        value.sum.push_back({other, -factor});
      else if (!isUnit(factor))
        value.denominator = factor;
    }
  }
  return out;
}

template <class Ring>
std::optional<LatticeBasis<Ring>> solveRelations(int variableCount,
                                                 const std::vector<RingSum<Ring>>& relations) {
  LatticeElimination<Ring> elimination(variableCount, relations);
  if (!elimination.run()) return {};
  return elimination.take();
}

template FreeVariables<Gaussian> eliminateRelations(int, const std::vector<RingSum<Gaussian>>&);
template FreeVariables<Eisenstein> eliminateRelations(int, const std::vector<RingSum<Eisenstein>>&);
template FreeVariables<Cyclotomic> eliminateRelations(int, const std::vector<RingSum<Cyclotomic>>&);
template std::optional<LatticeBasis<Gaussian>> solveRelations(
    int, const std::vector<RingSum<Gaussian>>&);
template std::optional<LatticeBasis<Eisenstein>> solveRelations(
    int, const std::vector<RingSum<Eisenstein>>&);

}  // namespace hgp
