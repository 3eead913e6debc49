#include "hgp/linalg/ordering/coarsening.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hgp::linalg {
namespace {

constexpr int kWindow = 1024;

// The partner across the heaviest edge; among equal edges the lighter partner, which keeps clusters even. One
// comparison of a combined score, because branches on mesh data are mispredicted.
int bestPartner(const WeightedGraph& g, int v, const std::vector<int>& cluster, int maxWeight) {
  int best = -1;
  std::int64_t bestScore = -1;
  const int room = maxWeight - g.vertexWeight[v];
  for (int e = g.start[v]; e < g.start[v + 1]; ++e) {
    const int u = g.neighbours[e];
    const std::int64_t score =
        (static_cast<std::int64_t>(g.edgeWeight[e]) << 32) - g.vertexWeight[u];
    const bool better =
        (int{cluster[u] < 0} & int{g.vertexWeight[u] <= room} & int{score > bestScore}) != 0;
    best = better ? u : best;
    bestScore = better ? score : bestScore;
  }
  return best;
}

// The order of matching: shuffled, because regular orders lead to long thin clusters, but only within windows,
// because a full shuffle causes cache misses.
std::vector<int> visitingOrder(int n) {
  std::vector<int> visit(static_cast<std::size_t>(n));
  for (int v = 0; v < n; ++v) visit[v] = v;
  std::uint64_t state = 88172645463325252u;  // xorshift: the same on every platform
  for (int begin = 0; begin < n; begin += kWindow) {
    const int end = std::min(n, begin + kWindow);
    for (int i = end - 1; i > begin; --i) {
      state ^= state << 13;
      state ^= state >> 7;
      state ^= state << 17;
      const auto range = static_cast<std::uint64_t>(i - begin + 1);
      std::swap(visit[i], visit[begin + static_cast<int>((state >> 20) % range)]);
    }
  }
  return visit;
}

// members[2c], members[2c + 1]: the one or two fine vertices of coarse vertex c. Coarse vertices are
// numbered along the fine ones, which keeps neighbours close in memory.
std::vector<int> match(const WeightedGraph& g, int maxWeight, std::vector<int>* cluster) {
  const int n = g.size();
  cluster->assign(static_cast<std::size_t>(n), -1);
  std::vector<int> mate(static_cast<std::size_t>(n), -1);
  for (const int v : visitingOrder(n)) {
    if ((*cluster)[v] >= 0) continue;
    (*cluster)[v] = 0;
    const int u = bestPartner(g, v, *cluster, maxWeight);
    if (u < 0) continue;
    (*cluster)[u] = 0;
    mate[v] = u;
    mate[u] = v;
  }
  std::vector<int> members;
  members.reserve(static_cast<std::size_t>(n) + 16);
  for (int v = 0; v < n; ++v) {
    if (mate[v] >= 0 && mate[v] < v) continue;
    (*cluster)[v] = static_cast<int>(members.size() / 2);
    if (mate[v] >= 0) (*cluster)[mate[v]] = (*cluster)[v];
    members.push_back(v);
    members.push_back(mate[v]);
  }
  return members;
}

}  // namespace

CoarseLevel coarsen(const WeightedGraph& fine, int maxWeight) {
  CoarseLevel level;
  const std::vector<int> members = match(fine, maxWeight, &level.cluster);
  const int n = static_cast<int>(members.size() / 2);
  WeightedGraph& g = level.graph;
  g.start.assign(static_cast<std::size_t>(n) + 1, 0);
  g.vertexWeight.resize(static_cast<std::size_t>(n));
  // one spare entry beyond what is kept
  g.neighbours.resize(fine.neighbours.size() + 2);
  g.edgeWeight.resize(fine.neighbours.size() + 2);
  std::vector<int> slot(static_cast<std::size_t>(n), -1);  // index of a neighbour in c's list
  int out = 0;
  for (int c = 0; c < n; ++c) {
    const int begin = out;
    slot[c] = out++;  // collects the edges inside the cluster, which are dropped at the end
    g.edgeWeight[begin] = 0;
    g.vertexWeight[c] = 0;
    for (int k = 0; k < 2; ++k) {
      const int v = members[2 * c + k];
      if (v < 0) continue;
      g.vertexWeight[c] += fine.vertexWeight[v];
      for (int e = fine.start[v]; e < fine.start[v + 1]; ++e) {
        const int d = level.cluster[fine.neighbours[e]];
        const bool isNew = slot[d] < begin;
        const int at = isNew ? out : slot[d];
        const int before = isNew ? 0 : g.edgeWeight[at];
        slot[d] = at;
        g.neighbours[at] = d;
        g.edgeWeight[at] = before + fine.edgeWeight[e];
        out += isNew;
      }
    }
    --out;
    g.neighbours[begin] = g.neighbours[out];
    g.edgeWeight[begin] = g.edgeWeight[out];
    slot[g.neighbours[out]] = begin;
    g.start[c + 1] = out;
  }
  g.neighbours.resize(static_cast<std::size_t>(out));
  g.edgeWeight.resize(static_cast<std::size_t>(out));
  return level;
}

}  // namespace hgp::linalg
