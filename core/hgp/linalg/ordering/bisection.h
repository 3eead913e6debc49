// Bisection of a graph.  Role: the inner loop of nested dissection.
#pragma once

#include <vector>

#include "hgp/linalg/graph/graph.h"
#include "hgp/linalg/ordering/weighted_graph.h"

namespace hgp::linalg {

/// A part of a larger graph; `vertex` has the ids of the part's vertices there.
struct Part {
  WeightedGraph graph;
  std::vector<int> vertex;
  std::vector<CoarseLevel> levels;  ///< ever coarser copies; a part may inherit them from its whole
  int inherited = 0;                ///< number of generations since they were computed
};

/// Side 0 or 1 of every vertex such that the weight of the edges across is small and neither side
/// weighs more than `imbalance` × the whole (as far as the weights allow). Multilevel: heavy-edge
/// matching down to a few dozen clusters, greedy growth, Fiduccia–Mattheyses on the way back.
/// Deterministic. A graph of fewer than two vertices leaves side 1 empty. Completes part->levels.
std::vector<char> bisect(Part* part, double imbalance);

/// The vertices of one side. Coarser copies are split as well and inherited for a few generations, which
/// is much cheaper than coarsening again.
Part subPart(const Part& whole, const std::vector<char>& side, char which);

/// The smallest set that meets every pair (a on side 0, b on side 1) at distance ≤ width in the whole
/// graph (1 or 2; the path may run outside the part): minimum vertex cover of those pairs, by
/// maximum matching. Its members get side 2. `local` is scratch of |whole| entries, all −1.
void coverCut(const Graph& whole, const Part& part, int width, std::vector<int>* local,
              std::vector<char>* side);

/// Vertices of more neighbours than this are kept out of dissections: max(100, 10 √|V|).
int denseDegree(int vertexCount);

}  // namespace hgp::linalg
