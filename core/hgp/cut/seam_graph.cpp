#include "hgp/cut/seam_graph.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

#include "hgp/base/disjoint_sets.h"

namespace hgp {
namespace {

/// The nodes of the filled surface with their edges as adjacency lists.
struct NodeGraph {
  struct Link {
    int to;
    EdgeId edge;
  };
  std::vector<int> start;
  std::vector<Link> links;
};

NodeGraph buildNodeGraph(const TriMesh& mesh, const FilledSurface& surface) {
  NodeGraph graph;
  graph.start.assign(static_cast<std::size_t>(surface.nodeCount) + 1, 0);
  const auto visit = [&](auto&& use) {
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const int a = surface.node[mesh.tail(h)], b = surface.node[mesh.head(h)];
      if (a == b || mesh.isBoundary(h)) continue;
      use(a, b, e);
      use(b, a, e);
    }
  };
  visit([&](int a, int, EdgeId) { ++graph.start[static_cast<std::size_t>(a) + 1]; });
  std::partial_sum(graph.start.begin(), graph.start.end(), graph.start.begin());
  graph.links.resize(static_cast<std::size_t>(graph.start.back()));
  std::vector<int> fill(graph.start.begin(), graph.start.end() - 1);
  visit([&](int a, int b, EdgeId e) {
    graph.links[static_cast<std::size_t>(fill[static_cast<std::size_t>(a)]++)] = {b, e};
  });
  return graph;
}

struct ShortestPaths {
  std::vector<double> distance;
  std::vector<int> source;    ///< nearest source node
  std::vector<int> previous;  ///< node before this one; −1 at a source
  std::vector<EdgeId> via;
};

/// Dijkstra from all sources at once.
ShortestPaths shortestPaths(const NodeGraph& graph, const PerEdge<double>& cost,
                            const std::vector<int>& sources) {
  const auto n = graph.start.size() - 1;
  ShortestPaths paths{std::vector<double>(n, std::numeric_limits<double>::infinity()),
                      std::vector<int>(n, -1), std::vector<int>(n, -1), std::vector<EdgeId>(n)};
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (int s : sources) {
    paths.distance[static_cast<std::size_t>(s)] = 0.0;
    paths.source[static_cast<std::size_t>(s)] = s;
    queue.push({0.0, s});
  }
  while (!queue.empty()) {
    const auto [d, a] = queue.top();
    queue.pop();
    const auto at = static_cast<std::size_t>(a);
    if (d > paths.distance[at]) continue;
    for (int l = graph.start[at]; l < graph.start[at + 1]; ++l) {
      const auto [b, e] = graph.links[static_cast<std::size_t>(l)];
      const double reached = d + cost[e];
      const auto to = static_cast<std::size_t>(b);
      if (reached >= paths.distance[to]) continue;
      paths.distance[to] = reached;
      paths.source[to] = paths.source[at];
      paths.previous[to] = a;
      paths.via[to] = e;
      queue.push({reached, b});
    }
  }
  return paths;
}

/// Mehlhorn's Steiner tree: the minimum spanning tree of the terminals' Voronoi adjacencies, each
/// adjacency drawn as the shortest path through it. Overlapping paths never close a cycle, since
/// they follow one shortest-path forest plus one crossing edge per tree edge.
void markSteinerTree(const TriMesh& mesh, const FilledSurface& surface, const NodeGraph& graph,
                     const PerEdge<double>& length, const std::vector<int>& terminals,
                     PerEdge<char>& isTree) {
  const ShortestPaths paths = shortestPaths(graph, length, terminals);
  struct Bridge {
    double length;
    EdgeId edge;
    int a, b;
  };
  std::vector<Bridge> bridges;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    const int a = surface.node[mesh.tail(h)], b = surface.node[mesh.head(h)];
    const auto at = static_cast<std::size_t>(a), bt = static_cast<std::size_t>(b);
    if (a == b || mesh.isBoundary(h) || paths.source[at] == paths.source[bt]) continue;
    bridges.push_back({paths.distance[at] + length[e] + paths.distance[bt], e, a, b});
  }
  std::sort(bridges.begin(), bridges.end(), [](const Bridge& x, const Bridge& y) {
    return x.length != y.length ? x.length < y.length : x.edge < y.edge;
  });
  DisjointSets forest(surface.nodeCount);
  for (const Bridge& bridge : bridges) {
    if (!forest.join(paths.source[static_cast<std::size_t>(bridge.a)],
                     paths.source[static_cast<std::size_t>(bridge.b)]))
      continue;
    isTree[bridge.edge] = 1;
    for (int node : {bridge.a, bridge.b})
      for (auto n = static_cast<std::size_t>(node); paths.previous[n] >= 0 && !isTree[paths.via[n]];
           n = static_cast<std::size_t>(paths.previous[n]))
        isTree[paths.via[n]] = 1;
  }
}

/// Maximum spanning tree of the dual graph by loop length, so that the 2g edges left over close the
/// shortest loops; returns those edges.
std::vector<EdgeId> leftoverEdges(const TriMesh& mesh, const FilledSurface& surface,
                                  const PerEdge<double>& length, const PerEdge<char>& isTree,
                                  const ShortestPaths& paths) {
  struct Crossing {
    double loop;
    EdgeId edge;
  };
  std::vector<Crossing> crossings;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (mesh.isBoundary(h) || isTree[e]) continue;
    const auto a = static_cast<std::size_t>(surface.node[mesh.tail(h)]);
    const auto b = static_cast<std::size_t>(surface.node[mesh.head(h)]);
    crossings.push_back({paths.distance[a] + length[e] + paths.distance[b], e});
  }
  std::sort(crossings.begin(), crossings.end(), [](const Crossing& x, const Crossing& y) {
    return x.loop != y.loop ? x.loop > y.loop : x.edge < y.edge;
  });
  DisjointSets forest(mesh.faceCount());
  std::vector<EdgeId> rest;
  for (const Crossing& c : crossings) {
    const HalfedgeId h = mesh.halfedge(c.edge);
    if (!forest.join(TriMesh::face(h).i, TriMesh::face(mesh.twin(h)).i)) rest.push_back(c.edge);
  }
  return rest;
}

/// Extends a Steiner tree so that the handles are cut open: a spanning tree that contains it (its edges cost
/// nothing, everything else is reached by shortest paths from it), and the edges in neither tree.
void markHandles(const TriMesh& mesh, const FilledSurface& surface, const NodeGraph& graph,
                 const PerEdge<double>& length, std::vector<int> sources, PerEdge<char>& isSeam) {
  if (sources.empty()) sources.push_back(0);
  for (EdgeId e : mesh.edges()) {
    if (!isSeam[e]) continue;
    const HalfedgeId h = mesh.halfedge(e);
    sources.push_back(surface.node[mesh.tail(h)]);
    sources.push_back(surface.node[mesh.head(h)]);
  }
  const ShortestPaths paths = shortestPaths(graph, length, sources);
  for (int n = 0; n < surface.nodeCount; ++n)
    if (paths.previous[static_cast<std::size_t>(n)] >= 0)
      isSeam[paths.via[static_cast<std::size_t>(n)]] = 1;
  for (EdgeId e : leftoverEdges(mesh, surface, length, isSeam, paths)) isSeam[e] = 1;
}

/// Euler characteristic of the filled surface, 2 − 2g.
int eulerCharacteristic(const TriMesh& mesh, const FilledSurface& surface) {
  int edges = 0;
  for (EdgeId e : mesh.edges()) edges += !mesh.isBoundary(mesh.halfedge(e));
  return surface.nodeCount - edges + mesh.faceCount();
}

/// Removes edges that end at a node that is not a terminal and has no other seam edge.
void trimLeaves(const TriMesh& mesh, const FilledSurface& surface, const NodeGraph& graph,
                const std::vector<int>& terminals, PerEdge<char>& isSeam) {
  std::vector<int> degree(static_cast<std::size_t>(surface.nodeCount), 0);
  for (EdgeId e : mesh.edges()) {
    if (!isSeam[e]) continue;
    const HalfedgeId h = mesh.halfedge(e);
    ++degree[static_cast<std::size_t>(surface.node[mesh.tail(h)])];
    ++degree[static_cast<std::size_t>(surface.node[mesh.head(h)])];
  }
  for (int t : terminals) degree[static_cast<std::size_t>(t)] += 2;  // so that none is a leaf
  std::vector<int> leaves;
  for (int n = 0; n < surface.nodeCount; ++n)
    if (degree[static_cast<std::size_t>(n)] == 1) leaves.push_back(n);
  while (!leaves.empty()) {
    const auto n = static_cast<std::size_t>(leaves.back());
    leaves.pop_back();
    for (int l = graph.start[n]; l < graph.start[n + 1]; ++l) {
      const auto [to, e] = graph.links[static_cast<std::size_t>(l)];
      if (!isSeam[e]) continue;
      isSeam[e] = 0;
      --degree[n];
      if (--degree[static_cast<std::size_t>(to)] == 1) leaves.push_back(to);
    }
  }
}

}  // namespace

PerEdge<char> seamGraph(const TriMesh& mesh, const Geometry& geometry, const FilledSurface& surface,
                        const std::vector<VertexId>& cones) {
  std::vector<int> terminals = surface.loopNode;
  for (VertexId v : cones) terminals.push_back(surface.node[v]);
  PerEdge<double> length(static_cast<std::size_t>(mesh.edgeCount()));
  for (EdgeId e : mesh.edges()) length[e] = geometry.length[mesh.halfedge(e)];

  const NodeGraph graph = buildNodeGraph(mesh, surface);
  PerEdge<char> isSeam(static_cast<std::size_t>(mesh.edgeCount()), 0);
  if (terminals.size() > 1) markSteinerTree(mesh, surface, graph, length, terminals, isSeam);

  if (eulerCharacteristic(mesh, surface) != 2)
    markHandles(mesh, surface, graph, length, terminals, isSeam);
  trimLeaves(mesh, surface, graph, terminals, isSeam);
  return isSeam;
}

}  // namespace hgp
