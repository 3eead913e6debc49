// Linear expressions in the reduced unknowns.  Role: positions of corners while a cone moves.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp::live {

struct Term {
  int unknown;
  Complex factor;
};
/// Σ factor · x[unknown]; a few terms, in any order, each unknown at most once.
using Terms = std::vector<Term>;

/// Adds factor · from to `to`. Factors that cancel up to rounding are left out.
inline void add(const Terms& from, const Complex& factor, Terms& to) {
  constexpr double kCancelled = 1e-13;
  for (const Term& t : from) {
    const auto same =
        std::find_if(to.begin(), to.end(), [&](const Term& o) { return o.unknown == t.unknown; });
    if (same == to.end())
      to.push_back({t.unknown, factor * t.factor});
    else
      same->factor += factor * t.factor;
  }
  std::erase_if(to, [](const Term& t) { return std::norm(t.factor) < kCancelled * kCancelled; });
}

inline Complex valueOf(const Terms& terms, const Eigen::VectorXcd& x) {
  Complex sum = 0.0;
  for (const Term& t : terms) sum += t.factor * x[t.unknown];
  return sum;
}

}  // namespace hgp::live
