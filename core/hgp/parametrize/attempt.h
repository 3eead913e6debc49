// One state turned into a map and verified.  Role: from the strategy's values to a program and back.
#pragma once

#include "hgp/parametrize/parametrization.h"
#include "hgp/parametrize/strategy.h"

namespace hgp {

/// Poses, solves, lays out and verifies. What several states share is found once.
class Attempts {
 public:
  Attempts(const Problem& problem, const ParametrizeOptions& options);

  /// Null when the caller cancelled.
  std::shared_ptr<const Attempt> make(const State& state, int round);

 private:
  PerVertex<double> scaleOf(const State& state) const;
  Frames framesOf(const State& state) const;
  const SeamRotations& seamsOf(const State& state) const;
  bool solve(const State& state, int round, Attempt& attempt);
  bool untangleFrom(const State& state, int round, Attempt& attempt);

  const Problem& problem_;
  const ParametrizeOptions& options_;
  Verifier verifier_;
};

}  // namespace hgp
