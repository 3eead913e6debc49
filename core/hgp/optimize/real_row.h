// A row of a program over real unknowns.  Role: collects the terms of rows and conditions (straight_program.h).
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hgp/features/real_unknowns.h"
#include "hgp/features/sum_relations.h"

namespace hgp {

/// A sparse sum over the unknowns, collected term by term.
class RealRow {
 public:
  /// @param index  −1 where an unknown has the value that `given` has
  RealRow(const RealUnknowns& unknowns, const std::vector<int>& index,
          const std::vector<double>& given)
      : unknowns_(unknowns),
        index_(index),
        given_(given),
        value_(index.size(), 0.0),
        isUsed_(index.size(), 0) {}

  /// Adds factor times the real (part 0) or imaginary part (1) of a copy.
  void add(int copy, int part, double factor) {
    for (RealUnknowns::Rows::InnerIterator it(unknowns_.rows, 2 * copy + part); it; ++it)
      addUnknown(static_cast<int>(it.col()), factor * it.value());
  }
  void add(const RealSum& sum, double factor) {
    for (const auto& [unknown, value] : sum) addUnknown(unknown, factor * value);
  }
  /// Calls use(index, value) for every term, ascending, and clears the row.
  /// @return what given unknowns add
  template <class Use>
  double take(const Use& use) {
    std::sort(used_.begin(), used_.end());
    for (const int unknown : used_) {
      const auto i = static_cast<std::size_t>(unknown);
      if (value_[i] != 0.0) use(index_[i], value_[i]);
      value_[i] = 0.0;
      isUsed_[i] = 0;
    }
    used_.clear();
    return std::exchange(constant_, 0.0);
  }

 private:
  void addUnknown(int unknown, double factor) {
    const auto i = static_cast<std::size_t>(unknown);
    if (index_[i] < 0) {
      constant_ += factor * given_[i];
      return;
    }
    if (!isUsed_[i]) {
      isUsed_[i] = 1;
      used_.push_back(unknown);
    }
    value_[i] += factor;
  }

  const RealUnknowns& unknowns_;
  const std::vector<int>& index_;
  const std::vector<double>& given_;
  double constant_ = 0.0;
  std::vector<double> value_;
  std::vector<char> isUsed_;
  std::vector<int> used_;
};

}  // namespace hgp
