#include "hgp/features/sum_relations.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace hgp {
namespace {

class Elimination {
 public:
  explicit Elimination(std::vector<RealSum> sums) : sums_(std::move(sums)) {
    for (std::size_t r = 0; r < sums_.size(); ++r)
      for (const auto& [variable, factor] : sums_[r]) users_[variable].insert(r);
  }

  std::optional<std::map<int, RealSum>> run() {
    std::map<int, std::size_t> rowOf;
    std::set<std::pair<std::size_t, std::size_t>> open;
    for (std::size_t r = 0; r < sums_.size(); ++r) open.insert({sums_[r].size(), r});
    while (!open.empty()) {
      const std::size_t r = open.begin()->second;
      open.erase(open.begin());
      if (sums_[r].empty()) continue;
      const int pivot = choosePivot(r);
      const double scale = 1.0 / sums_[r].at(pivot);
      for (auto& [variable, factor] : sums_[r]) factor *= scale;
      if (!isExact(r)) return {};
      rowOf[pivot] = r;
      const std::set<std::size_t> users = users_[pivot];
      for (const std::size_t other : users) {
        if (other == r) continue;
        const bool isOpen = open.erase({sums_[other].size(), other}) > 0;
        subtract(other, sums_[other].at(pivot), r);
        if (!isExact(other)) return {};
        if (isOpen) open.insert({sums_[other].size(), other});
      }
    }
    std::map<int, RealSum> solved;
    for (const auto& [pivot, r] : rowOf) {
      RealSum& sum = solved[pivot];
      for (const auto& [variable, factor] : sums_[r])
        if (variable != pivot) sum[variable] = -factor;
    }
    return solved;
  }

 private:
  bool isExact(std::size_t r) const {
    return std::all_of(sums_[r].begin(), sums_[r].end(),
                       [](const auto& term) { return isExactFactor(term.second); });
  }
  void subtract(std::size_t target, double factor, std::size_t source) {
    for (const auto& [variable, value] : sums_[source]) {
      double& entry = sums_[target][variable];
      entry -= factor * value;
      if (entry != 0.0) {
        users_[variable].insert(target);
      } else {
        sums_[target].erase(variable);
        users_[variable].erase(target);
      }
    }
  }
  /// The smallest coefficient; of equal ones, that of the variable in the fewest sums.
  int choosePivot(std::size_t r) const {
    int best = -1;
    double size = 0.0;
    for (const auto& [variable, factor] : sums_[r]) {
      const double own = std::fabs(factor);
      if (best >= 0 &&
          (own > size || (own == size && users_.at(variable).size() >= users_.at(best).size())))
        continue;
      best = variable;
      size = own;
    }
    return best;
  }

  std::vector<RealSum> sums_;
  std::map<int, std::set<std::size_t>> users_;
};

}  // namespace

bool isExactFactor(double x) {
  return kFactorSteps * x == std::nearbyint(kFactorSteps * x) && std::fabs(x) < kLargestFactor;
}

void addTo(RealSum& sum, const RealSum& other, double factor) {
  for (const auto& [variable, value] : other) {
    double& entry = sum[variable];
    entry += factor * value;
    if (entry == 0.0) sum.erase(variable);
  }
}

std::optional<std::map<int, RealSum>> solveSums(std::vector<RealSum> relations) {
  return Elimination(std::move(relations)).run();
}

}  // namespace hgp
