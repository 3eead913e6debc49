#include "hgp/base/phrase.h"

namespace hgp {

namespace {

// An entry begins on a line of its own: wasm/phrases.mjs reads the catalogue. Defects are apart, because nothing else is
// phrased in the core itself, and programs that phrase everything on their own need not contain the rest.
constexpr Phrase kDefects[] = {
    // A defect: of a mesh that is refused, or one that was repaired.
    {"defect-index-out-of-range",
     "[repaired:repaired: ]{count|face names|faces name} a vertex that does not exist"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-not-finite",
     "[repaired:repaired: ]{count|vertex has|vertices have} a position that is not finite"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-extent",
     "[repaired:repaired: ]the mesh is too large or too small to compute with (1e-100 to 1e18)"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-repeated-vertex",
     "[repaired:repaired: ]{count|face names|faces name} one vertex twice"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-zero-area",
     "[repaired:repaired: ]{count|face has|faces have} no area[first: (first: {@})][only: ({@})]"},
    {"defect-duplicate-face",
     "[repaired:repaired: ]{count|face repeats|faces repeat} another one"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-non-manifold-edge",
     "[repaired:repaired: ]{count|edge has|edges have} more than two faces"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-inconsistent-edge",
     "[repaired:repaired: ]{count|edge has|edges have} two faces of opposite orientation"
     "[first: (first: {@})][only: ({@})]"},
    {"defect-non-manifold-vertex",
     "[repaired:repaired: ]{count|vertex joins|vertices join} several fans of faces"
     "[first: (first: {@})][only: ({@})]"},
};

}  // namespace

std::span<const Phrase> defectPhrases() { return kDefects; }

}  // namespace hgp
