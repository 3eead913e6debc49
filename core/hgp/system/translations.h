// Linear relations between the translations of seam chains, solved exactly once.  Role: the
// composed translation around a seam node with trivial rotation vanishes [BCW17 §4, (12)].
#pragma once

#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

/// A sparse linear combination of translations t_c.
struct TranslationTerm {
  int chain;
  Complex factor;
};
using TranslationSum = std::vector<TranslationTerm>;

/// Solves Σ factor · t_chain = 0 for every given sum: each eliminates one translation, chosen to keep the other
/// expressions short. Redundant relations are dropped.
/// @return per chain, its translation in terms of the free ones (the chain itself if it is free)
std::vector<TranslationSum> solveTranslations(int chainCount,
                                              std::vector<TranslationSum> relations);

}  // namespace hgp
