// Removes edges with the same ends.  Role: a remedy for a few of them, where cutting every cell into four or sixteen would
// change all quads.
#pragma once

#include "hgp/quads/quads.h"

namespace hgp {

struct CutQuads {
  QuadMesh quads;
  int cuts = 0;      ///< lines that were added, each along a strip
  int replaced = 0;  ///< or: edges that were replaced
  int added = 0;     ///< quads more than without them
};

/// Strips that add at most this share of quads are cut, or at most this multiple of what replacing edges adds;
/// otherwise edges are replaced.
inline constexpr double kMaxAdded = 0.08;
inline constexpr int kWorthwhile = 2;

/// The quads of a map without multiple edges (countMultipleEdges): with a few grid lines in addition where they are short,
/// and otherwise with some edges replaced (refill), which leaves a few vertices of valence 3 and 5. An added
/// line runs in the middle of a strip of quads, from one end of it to the other or around, so that all faces remain
/// quads that meet edge to edge. It crosses one of the edges that have the same ends, or both; of the lines that do, the
/// shortest is added. Lines added may make further ones necessary, a quarter of a cell from a grid line. Strips may run
/// over much of the surface.
/// `features`: as for extractQuads; edges along them are not replaced.
/// Fails as extractQuads; with kUnsupported where multiple edges remain.
/// The quads of two halvings are extracted on the way.
Result<CutQuads> cutStrips(const TriMesh& mesh, const UvMap& map, int q,
                           const std::vector<EdgeId>& features = {});

}  // namespace hgp
