#include "hgp/linalg/ordering/bisection.h"

#include <algorithm>
#include <climits>
#include <cstdint>
#include <numeric>
#include <queue>

#include "hgp/linalg/ordering/coarsening.h"

namespace hgp::linalg {
namespace {

constexpr int kCoarsest = 48;    // small enough for several trial cuts
constexpr int kTrials = 3;       // greedy growths tried on the coarsest graph,
constexpr int kTrialsLarge = 8;  // and for parts of more than kLarge vertices, whose cuts matter
constexpr int kLarge = 4000;     // most and for which trials cost relatively little
constexpr int kMaxPasses = 4;    // FM passes per level; they stop when nothing improves

struct Move {
  int gain;
  int vertex;
  // Equal gains: the smaller index first, so that every platform takes the same path.
  friend bool operator<(const Move& a, const Move& b) {
    return a.gain != b.gain ? a.gain < b.gain : a.vertex > b.vertex;
  }
};

// Fiduccia–Mattheyses on one level: moves single vertices, best gain first, keeps the best prefix.
class Refiner {
 public:
  Refiner(const WeightedGraph& graph, double imbalance, std::vector<char>* side)
      : g_(graph), side_(*side), gain_(side->size(), 0), stamp_(side->size(), 0) {
    for (int v = 0; v < g_.size(); ++v) weight_[side_[v] == 0 ? 0 : 1] += g_.vertexWeight[v];
    const std::int64_t total = weight_[0] + weight_[1];
    limit_ = static_cast<std::int64_t>(imbalance * static_cast<double>(total));
    patience_ = std::clamp(g_.size() / 100, 15, 60);
  }

  /// `candidates` holds at least every vertex with a neighbour on the other side; on return exactly
  /// those.
  void refine(std::vector<int>* candidates) {
    for (int pass = 0; pass < kMaxPasses; ++pass)
      if (!runPass(candidates)) break;
    keepBoundary(candidates);
  }

 private:
  static constexpr int kLocked = INT_MAX;

  int computeGain(int v) const {
    int gain = 0;
    for (int e = g_.start[v]; e < g_.start[v + 1]; ++e)
      gain += side_[g_.neighbours[e]] != side_[v] ? g_.edgeWeight[e] : -g_.edgeWeight[e];
    return gain;
  }
  bool isBoundary(int v) const {
    for (int e = g_.start[v]; e < g_.start[v + 1]; ++e)
      if (side_[g_.neighbours[e]] != side_[v]) return true;
    return false;
  }
  void keepBoundary(std::vector<int>* candidates) const {
    std::erase_if(*candidates, [&](int v) { return !isBoundary(v); });
  }
  void push(int v) { heap_[side_[v] == 0 ? 0 : 1].push({gain_[v], v}); }

  // Drops outdated entries; −1 when the heap is empty.
  int top(int s) {
    auto& heap = heap_[s];
    while (!heap.empty()) {
      const Move m = heap.top();
      if (stamp_[m.vertex] != kLocked && side_[m.vertex] == s && gain_[m.vertex] == m.gain)
        return m.vertex;
      heap.pop();
    }
    return -1;
  }
  bool fits(int v, int from) const {
    const std::int64_t after = weight_[1 - from] + g_.vertexWeight[v];
    return after <= limit_ || after < weight_[from];
  }

  int chooseMove() {
    const int a = top(0), b = top(1);
    const bool canA = a >= 0 && fits(a, 0), canB = b >= 0 && fits(b, 1);
    if (!canA && !canB) return -1;
    if (weight_[0] > limit_ && canA) return a;
    if (weight_[1] > limit_ && canB) return b;
    if (!canB) return a;
    if (!canA) return b;
    if (gain_[a] != gain_[b]) return gain_[a] > gain_[b] ? a : b;
    return weight_[0] >= weight_[1] ? a : b;
  }

  void move(int v) {
    const int from = side_[v] == 0 ? 0 : 1;
    side_[v] = static_cast<char>(1 - from);
    weight_[from] -= g_.vertexWeight[v];
    weight_[1 - from] += g_.vertexWeight[v];
  }

  void moveAndUpdate(int v) {
    move(v);
    stamp_[v] = kLocked;
    for (int e = g_.start[v]; e < g_.start[v + 1]; ++e) {
      const int u = g_.neighbours[e];
      if (stamp_[u] == kLocked) continue;
      if (stamp_[u] != pass_) {
        stamp_[u] = pass_;
        gain_[u] = computeGain(u);
      } else {
        gain_[u] += side_[u] != side_[v] ? 2 * g_.edgeWeight[e] : -2 * g_.edgeWeight[e];
      }
      push(u);
    }
  }

  // How far the heavier side is over its limit, then how uneven the sides are.
  std::int64_t excess() const {
    return std::max<std::int64_t>(0, std::max(weight_[0], weight_[1]) - limit_);
  }

  bool runPass(std::vector<int>* candidates) {
    ++pass_;
    heap_[0] = {};
    heap_[1] = {};
    for (const int v : *candidates) {
      if (!isBoundary(v) && excess() == 0) continue;
      stamp_[v] = pass_;
      gain_[v] = computeGain(v);
      push(v);
    }
    std::int64_t gained = 0, bestGain = 0, bestExcess = excess();
    std::int64_t bestSpread = std::abs(weight_[0] - weight_[1]);
    const std::int64_t firstExcess = bestExcess;
    std::vector<int> moved;
    std::size_t keep = 0;
    for (int idle = 0; idle < patience_; ++idle) {
      const int v = chooseMove();
      if (v < 0) break;
      gained += gain_[v];
      moveAndUpdate(v);
      moved.push_back(v);
      const std::int64_t over = excess(), spread = std::abs(weight_[0] - weight_[1]);
      const bool better = over != bestExcess   ? over < bestExcess
                          : gained != bestGain ? gained > bestGain
                                               : spread < bestSpread;
      if (!better) continue;
      bestGain = gained;
      bestExcess = over;
      bestSpread = spread;
      keep = moved.size();
      idle = 0;
    }
    for (std::size_t i = moved.size(); i > keep; --i) move(moved[i - 1]);
    collectTouched(moved, keep, candidates);
    for (const int v : moved) stamp_[v] = 0;
    return bestGain > 0 || bestExcess < firstExcess;
  }

  // Moved vertices and their neighbours may have joined the boundary.
  void collectTouched(const std::vector<int>& moved, std::size_t keep,
                      std::vector<int>* candidates) {
    for (std::size_t i = 0; i < keep; ++i) {
      candidates->push_back(moved[i]);
      for (int e = g_.start[moved[i]]; e < g_.start[moved[i] + 1]; ++e)
        candidates->push_back(g_.neighbours[e]);
    }
    std::sort(candidates->begin(), candidates->end());
    candidates->erase(std::unique(candidates->begin(), candidates->end()), candidates->end());
  }

  const WeightedGraph& g_;
  std::vector<char>& side_;
  std::vector<int> gain_;
  std::vector<int> stamp_;  // pass in which gain_ was computed, or kLocked
  std::priority_queue<Move> heap_[2];
  std::int64_t weight_[2] = {0, 0};
  std::int64_t limit_ = 0;
  int patience_ = 15;
  int pass_ = 0;
};

std::int64_t cutWeight(const WeightedGraph& g, const std::vector<char>& side) {
  std::int64_t cut = 0;
  for (int v = 0; v < g.size(); ++v)
    for (int e = g.start[v]; e < g.start[v + 1]; ++e)
      if (side[v] < side[g.neighbours[e]]) cut += g.edgeWeight[e];
  return cut;
}

// Grows side 0 from a seed, always by the vertex that adds least to the cut, to half the weight.
std::vector<char> growHalf(const WeightedGraph& g, int seed) {
  const int n = g.size();
  std::vector<char> side(static_cast<std::size_t>(n), 1);
  std::vector<int> gain(static_cast<std::size_t>(n), INT_MIN);
  std::int64_t total = 0, grown = 0;
  for (const int w : g.vertexWeight) total += w;
  std::priority_queue<Move> heap;
  int nextSeed = seed;
  for (int taken = 0; taken < n && 2 * grown < total; ++taken) {
    int v = -1;
    while (!heap.empty() && v < 0) {
      const Move m = heap.top();
      heap.pop();
      if (side[m.vertex] == 1 && gain[m.vertex] == m.gain) v = m.vertex;
    }
    while (v < 0) {  // a new component
      if (side[nextSeed] == 1) v = nextSeed;
      nextSeed = nextSeed + 1 == n ? 0 : nextSeed + 1;
    }
    side[v] = 0;
    grown += g.vertexWeight[v];
    for (int e = g.start[v]; e < g.start[v + 1]; ++e) {
      const int u = g.neighbours[e];
      if (side[u] == 0) continue;
      if (gain[u] == INT_MIN) {
        gain[u] = 0;
        for (int f = g.start[u]; f < g.start[u + 1]; ++f)
          gain[u] += side[g.neighbours[f]] == 0 ? g.edgeWeight[f] : -g.edgeWeight[f];
      } else {
        gain[u] += 2 * g.edgeWeight[e];
      }
      heap.push({gain[u], u});
    }
  }
  return side;
}

std::vector<int> allVertices(int n) {
  std::vector<int> all(static_cast<std::size_t>(n));
  for (int v = 0; v < n; ++v) all[v] = v;
  return all;
}

std::vector<char> bestSmallCut(const WeightedGraph& g, double imbalance, int wantedTrials,
                               std::vector<int>* boundary) {
  std::vector<char> best;
  std::int64_t bestCut = INT64_MAX;
  const int trials = g.size() > 4 * kCoarsest ? 2 : std::min(wantedTrials, g.size());
  for (int t = 0; t < trials; ++t) {
    const int seed = static_cast<int>((static_cast<std::int64_t>(t) * g.size()) / trials);
    std::vector<char> side = growHalf(g, seed);
    std::vector<int> candidates = allVertices(g.size());
    Refiner(g, imbalance, &side).refine(&candidates);
    const std::int64_t cut = cutWeight(g, side);
    if (cut >= bestCut) continue;
    bestCut = cut;
    best = std::move(side);
    *boundary = std::move(candidates);
  }
  return best;
}

// Transfers the sides to the finer level; returns the vertices that may lie on the boundary there.
std::vector<int> project(const CoarseLevel& level, const std::vector<char>& coarseSide,
                         const std::vector<int>& coarseBoundary, std::vector<char>* side) {
  std::vector<char> marked(coarseSide.size(), 0);
  for (const int c : coarseBoundary) marked[c] = 1;
  const int n = static_cast<int>(level.cluster.size());
  side->resize(static_cast<std::size_t>(n));
  std::vector<int> candidates;
  for (int v = 0; v < n; ++v) {
    const int c = level.cluster[v];
    (*side)[v] = coarseSide[c];
    if (marked[c]) candidates.push_back(v);
  }
  return candidates;
}

}  // namespace

std::vector<char> bisect(Part* part, double imbalance) {
  const WeightedGraph& graph = part->graph;
  std::vector<CoarseLevel>& levels = part->levels;
  if (graph.size() < 2) return std::vector<char>(static_cast<std::size_t>(graph.size()), 0);
  const std::int64_t total =
      std::accumulate(graph.vertexWeight.begin(), graph.vertexWeight.end(), std::int64_t{0});
  const int maxCluster = static_cast<int>(std::max<std::int64_t>(2, total / 12));
  const auto graphAt = [&](std::size_t level) -> const WeightedGraph& {
    return level == 0 ? graph : levels[level - 1].graph;
  };
  while (graphAt(levels.size()).size() > kCoarsest) {
    const WeightedGraph& finest = graphAt(levels.size());
    CoarseLevel level = coarsen(finest, maxCluster);
    if (level.graph.size() > finest.size() * 19 / 20) break;  // stars and isolated vertices
    levels.push_back(std::move(level));
  }
  std::vector<int> boundary;
  std::vector<char> side = bestSmallCut(graphAt(levels.size()), imbalance,
                                        graph.size() > kLarge ? kTrialsLarge : kTrials, &boundary);
  for (std::size_t l = levels.size(); l > 0; --l) {
    const std::vector<char> coarseSide = std::move(side);
    boundary = project(levels[l - 1], coarseSide, boundary, &side);
    Refiner(graphAt(l - 1), imbalance, &side).refine(&boundary);
  }
  return side;
}

}  // namespace hgp::linalg
