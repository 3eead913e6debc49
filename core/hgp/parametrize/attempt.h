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
  Frames framesOf(const State& state);
  const SeamRotations& seamsOf(bool isEven);
  bool solve(const State& state, int round, Attempt& attempt);
  bool untangleFrom(const State& state, int round, Attempt& attempt);
  SeamRotations framesOfKind(const Untangling& kind);

  const Problem& problem_;
  const ParametrizeOptions& options_;
  Verifier verifier_;
  std::optional<SeamRotations> even_;
};

}  // namespace hgp
