#include "hgp/quads/multiple_edges.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "hgp/base/check.h"

namespace hgp {
namespace {

using Pair = std::array<int, 2>;

Pair unordered(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

}  // namespace

MultipleEdges countMultipleEdges(const QuadMesh& mesh) {
  const MultipleEdgePairs found = findMultipleEdges(mesh);
  return {static_cast<int>(found.pairs.size()), found.foldedQuads};
}

MultipleEdgePairs findMultipleEdges(const QuadMesh& mesh) {
  MultipleEdgePairs out;
  std::set<Pair>& pairs = out.pairs;
  std::vector<int> valence(mesh.positions.size(), 0);
  std::vector<Pair> directed;
  directed.reserve(4 * mesh.quads.size());
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      ++valence[at(quad[k])];
      directed.push_back({quad[k], quad[(k + 1) % 4]});
    }
  // The faces at an edge traverse it once in each direction: a directed pair that occurs twice belongs to two edges.
  std::sort(directed.begin(), directed.end());
  for (std::size_t n = 0; n < directed.size(); ++n) {
    const auto [a, b] = directed[n];
    if (a == b || (n > 0 && directed[n] == directed[n - 1])) pairs.insert(unordered(a, b));
  }
  for (const auto& quad : mesh.quads)
    for (std::size_t k = 0; k < 4; ++k) {
      const int before = quad[(k + 3) % 4], after = quad[(k + 1) % 4];
      if (valence[at(quad[k])] != 1 || before != after) continue;
      ++out.foldedQuads;
      pairs.erase(unordered(after, quad[(k + 2) % 4]));
    }
  return out;
}

}  // namespace hgp
