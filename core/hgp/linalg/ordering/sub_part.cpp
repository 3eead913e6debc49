#include "hgp/linalg/ordering/bisection.h"

namespace hgp::linalg {
namespace {

constexpr int kGenerations = 3;  // after that the clusters are too irregular
constexpr int kFewest = 48;      // coarser copies are not needed

// The subgraph of the vertices with name ≥ 0 (ascending names); vertex weights are left to the caller.
WeightedGraph subGraph(const WeightedGraph& whole, const std::vector<int>& name, int count) {
  WeightedGraph g;
  g.start.reserve(static_cast<std::size_t>(count) + 1);
  const std::size_t guess = whole.neighbours.size() * 11 / 20;
  g.neighbours.reserve(guess);
  g.edgeWeight.reserve(guess);
  for (int v = 0; v < whole.size(); ++v) {
    if (name[v] < 0) continue;
    for (int e = whole.start[v]; e < whole.start[v + 1]; ++e) {
      const int u = name[whole.neighbours[e]];
      if (u < 0) continue;
      g.neighbours.push_back(u);
      g.edgeWeight.push_back(whole.edgeWeight[e]);
    }
    g.start.push_back(static_cast<int>(g.neighbours.size()));
  }
  return g;
}

// The rest of a coarser copy: clusters with a remaining member, with the weight of their remaining members.
// Edges keep their weight, which may include removed edges; this suffices as a starting point.
CoarseLevel subLevel(const CoarseLevel& whole, const WeightedGraph& finer, std::vector<int>* name) {
  CoarseLevel level;
  std::vector<int> coarseName(static_cast<std::size_t>(whole.graph.size()), -1);
  for (std::size_t v = 0; v < name->size(); ++v)
    if ((*name)[v] >= 0) coarseName[whole.cluster[v]] = 0;
  int count = 0;
  for (int& c : coarseName)
    if (c == 0) c = count++;
  level.graph = subGraph(whole.graph, coarseName, count);
  level.graph.vertexWeight.assign(static_cast<std::size_t>(count), 0);
  level.cluster.reserve(finer.vertexWeight.size());
  for (std::size_t v = 0; v < name->size(); ++v) {
    if ((*name)[v] < 0) continue;
    const int c = coarseName[whole.cluster[v]];
    level.graph.vertexWeight[c] += finer.vertexWeight[(*name)[v]];
    level.cluster.push_back(c);
  }
  *name = std::move(coarseName);
  return level;
}

}  // namespace

Part subPart(const Part& whole, const std::vector<char>& side, char which) {
  Part part;
  std::vector<int> name(side.size(), -1);
  std::vector<int> weights;
  for (std::size_t v = 0; v < side.size(); ++v)
    if (side[v] == which) {
      name[v] = static_cast<int>(part.vertex.size());
      part.vertex.push_back(whole.vertex[v]);
      weights.push_back(whole.graph.vertexWeight[v]);
    }
  part.graph = subGraph(whole.graph, name, static_cast<int>(part.vertex.size()));
  part.graph.vertexWeight = std::move(weights);
  if (whole.inherited >= kGenerations) return part;
  part.inherited = whole.inherited + 1;
  const WeightedGraph* finer = &part.graph;
  part.levels.reserve(whole.levels.size());
  for (const CoarseLevel& level : whole.levels) {
    if (finer->size() <= kFewest) break;
    part.levels.push_back(subLevel(level, *finer, &name));
    finer = &part.levels.back().graph;
  }
  return part;
}

}  // namespace hgp::linalg
