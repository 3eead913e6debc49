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

/// Solves Σ = 0 for every given sum: each eliminates one translation, chosen to keep the others'
/// expressions short. Redundant relations are dropped.
/// @return per chain its expression in the free translations (itself when it is free)
std::vector<TranslationSum> solveTranslations(int chainCount,
                                              std::vector<TranslationSum> relations);

}  // namespace hgp
