// Sums into the unknowns above a subtree, in the order of one thread.  Role: solves whose bits do not depend on threads.
#pragma once

#include <utility>
#include <vector>

#include "hgp/base/parallel.h"

namespace hgp::linalg {

/// Terms that the subtrees of a forest add to unknowns of nodes above them, each in the order of the nodes that add it, as if
/// one thread had visited all. An item takes the terms of the items below it with begin(), those that its own unknowns get
/// and those that it passes on.
template <class Term>
class DeferredSums {
 public:
  explicit DeferredSums(const ForestWork& nodes)
      : terms_(nodes.items().size()), below_(terms_.size()) {
    for (std::size_t i = 0; i < terms_.size(); ++i)
      if (nodes.items()[i].parent >= 0)
        below_[nodes.items()[i].parent].push_back(static_cast<int>(i));
  }

  /// Calls add(term) for the terms from below for which isOwn(term). To be called when all items below are done.
  template <class IsOwn, class Add>
  void begin(int item, const IsOwn& isOwn, const Add& add) {
    for (const int child : below_[item]) {
      for (const Term& term : terms_[child])
        if (isOwn(term))
          add(term);
        else
          terms_[item].push_back(term);
      terms_[child] = {};
    }
  }
  void push(int item, Term term) { terms_[item].push_back(std::move(term)); }
  /// Those that no item above has taken.
  const std::vector<Term>& left(int item) const { return terms_[item]; }

 private:
  std::vector<std::vector<Term>> terms_;
  std::vector<std::vector<int>> below_;
};

}  // namespace hgp::linalg
