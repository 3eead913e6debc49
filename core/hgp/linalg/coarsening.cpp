#include "hgp/linalg/coarsening.h"

namespace hgp::linalg {
namespace {

// Heaviest edge first; among equals the lighter partner, which keeps clusters even.
int bestPartner(const WeightedGraph& g, int v, const std::vector<int>& cluster, int maxWeight) {
  int best = -1, bestEdge = 0, bestWeight = 0;
  for (int e = g.start[v]; e < g.start[v + 1]; ++e) {
    const int u = g.neighbours[e];
    if (cluster[u] >= 0 || g.vertexWeight[u] + g.vertexWeight[v] > maxWeight) continue;
    const int edge = g.edgeWeight[e], weight = g.vertexWeight[u];
    if (best < 0 || edge > bestEdge || (edge == bestEdge && weight < bestWeight)) {
      best = u;
      bestEdge = edge;
      bestWeight = weight;
    }
  }
  return best;
}

// members[2c], members[2c + 1]: the one or two fine vertices of coarse vertex c.
std::vector<int> match(const WeightedGraph& g, int maxWeight, std::vector<int>* cluster) {
  const int n = g.size();
  cluster->assign(static_cast<std::size_t>(n), -1);
  std::vector<int> members;
  members.reserve(static_cast<std::size_t>(n) + 16);
  for (int v = 0; v < n; ++v) {
    if ((*cluster)[v] >= 0) continue;
    const int c = static_cast<int>(members.size() / 2);
    (*cluster)[v] = c;
    const int u = bestPartner(g, v, *cluster, maxWeight);
    if (u >= 0) (*cluster)[u] = c;
    members.push_back(v);
    members.push_back(u);
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
  g.neighbours.resize(fine.neighbours.size());
  g.edgeWeight.resize(fine.neighbours.size());
  std::vector<int> slot(static_cast<std::size_t>(n), -1);  // where c's list holds a neighbour
  int out = 0;
  for (int c = 0; c < n; ++c) {
    const int begin = out;
    g.vertexWeight[c] = 0;
    for (int k = 0; k < 2; ++k) {
      const int v = members[2 * c + k];
      if (v < 0) continue;
      g.vertexWeight[c] += fine.vertexWeight[v];
      for (int e = fine.start[v]; e < fine.start[v + 1]; ++e) {
        const int d = level.cluster[fine.neighbours[e]];
        if (d == c) continue;
        if (slot[d] < begin) {
          slot[d] = out;
          g.neighbours[out] = d;
          g.edgeWeight[out++] = fine.edgeWeight[e];
        } else {
          g.edgeWeight[slot[d]] += fine.edgeWeight[e];
        }
      }
    }
    g.start[c + 1] = out;
  }
  g.neighbours.resize(static_cast<std::size_t>(out));
  g.edgeWeight.resize(static_cast<std::size_t>(out));
  return level;
}

}  // namespace hgp::linalg
