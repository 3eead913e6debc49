// Solves the program of a state and verifies the map.  Role: one round of the loop.
#pragma once

#include "hgp/optimize/harmonic_basis.h"
#include "hgp/parametrize/parametrization.h"
#include "hgp/parametrize/strategy/state.h"

namespace hgp {

/// Caches what several states have in common.
class Attempts {
 public:
  Attempts(const Problem& problem, const ParametrizeOptions& options);

  /// Poses the program of `state`, solves it, and verifies the map. Null when `progress` cancelled.
  std::shared_ptr<const Attempt> make(const State& state, int round);

 private:
  PerVertex<double> scaleOf(const State& state) const;
  Frames framesOf(const State& state) const;
  const SeamRotations& seamsOf(const State& state) const;
  const HarmonicSystem& rowsOf(const State& state);
  std::shared_ptr<const HarmonicBasis> basisOf(const State& state, const Attempt& attempt);
  bool solve(const State& state, int round, Attempt& attempt);
  PerVertex<double> untanglingScale(const State& state, const Attempt& attempt) const;
  ProgramResult untanglingStart(const SeamlessSystem& system, const PerVertex<double>& u,
                                bool isFramed) const;
  bool untangleFrom(const State& state, int round, Attempt& attempt);

  const Problem& problem_;
  const ParametrizeOptions& options_;
  Verifier verifier_;
  std::optional<HarmonicSystem> cotangent_;     // rows with these weights, once they are asked for
  std::shared_ptr<const HarmonicBasis> basis_;  // of a harmonic weighting, while it lasts
  std::size_t basisWeighting_ = 0;
};

}  // namespace hgp
