#include <algorithm>
#include <cmath>

#include "hgp/linalg/ordering/bisection.h"

namespace hgp::linalg {
namespace {

// The pairs across the cut as a bipartite graph: left = side 0, right = side 1.
struct CutPairs {
  std::vector<int> left, right;        // vertices of the bisected graph
  std::vector<int> start{0}, partner;  // per left vertex: indices into right
};

// Second steps run through the whole graph: two vertices of a part may be at distance two only through
// a separator that was removed before. Paths through vertices of extreme degree do not count, see Dissector.
class PairFinder {
 public:
  PairFinder(const Graph& whole, const Part& part, const std::vector<int>& local, int maxDegree,
             const std::vector<char>& side)
      : whole_(whole),
        part_(part),
        local_(local),
        maxDegree_(maxDegree),
        side_(side),
        rightIndex_(side.size(), -1),
        seen_(side.size(), -1) {}

  CutPairs find(int width) {
    const int n = part_.graph.size();
    std::vector<char> onCut(static_cast<std::size_t>(n), 0);
    for (int v = 0; v < n; ++v) onCut[v] = touchesOther(v);
    for (int v = 0; v < n; ++v) {
      if (side_[v] != 0) continue;
      if (onCut[v] || (width == 2 && (hasOutside(v) || touches(v, onCut)))) addLeft(v, width);
    }
    return std::move(pairs_);
  }

 private:
  bool touchesOther(int v) const {
    const WeightedGraph& g = part_.graph;
    for (int e = g.start[v]; e < g.start[v + 1]; ++e)
      if (side_[g.neighbours[e]] != side_[v]) return true;
    return false;
  }
  bool touches(int v, const std::vector<char>& marked) const {
    const WeightedGraph& g = part_.graph;
    for (int e = g.start[v]; e < g.start[v + 1]; ++e)
      if (marked[g.neighbours[e]]) return true;
    return false;
  }
  bool hasOutside(int v) const {
    return part_.graph.start[v + 1] - part_.graph.start[v] < whole_.degree(part_.vertex[v]);
  }
  void addPair(int v, int u) {
    if (u < 0 || side_[u] == 0 || seen_[u] == v) return;
    seen_[u] = v;
    if (rightIndex_[u] < 0) {
      rightIndex_[u] = static_cast<int>(pairs_.right.size());
      pairs_.right.push_back(u);
    }
    pairs_.partner.push_back(rightIndex_[u]);
  }
  void addLeft(int v, int width) {
    const int name = part_.vertex[v];
    for (const int* u = whole_.begin(name); u != whole_.end(name); ++u) {
      addPair(v, local_[*u]);
      if (width < 2 || whole_.degree(*u) > maxDegree_) continue;
      for (const int* w = whole_.begin(*u); w != whole_.end(*u); ++w) addPair(v, local_[*w]);
    }
    if (static_cast<int>(pairs_.partner.size()) == pairs_.start.back()) return;
    pairs_.left.push_back(v);
    pairs_.start.push_back(static_cast<int>(pairs_.partner.size()));
  }

  const Graph& whole_;
  const Part& part_;
  const std::vector<int>& local_;
  int maxDegree_;
  const std::vector<char>& side_;
  std::vector<int> rightIndex_, seen_;
  CutPairs pairs_;
};

// Maximum matching by Hopcroft and Karp, without recursion.
class Matching {
 public:
  explicit Matching(const CutPairs& pairs)
      : p_(pairs), leftMate(pairs.left.size(), -1), rightMate(pairs.right.size(), -1) {
    greedy();
    while (layer())
      for (int l = 0; l < leftCount(); ++l)
        if (leftMate[l] < 0) augment(l);
  }

  /// Left vertices reachable from free left ones by alternating paths keep their partners' side in
  /// the cover: cover = unreached left ∪ reached right (König).
  void coverFromLeft(std::vector<char>* inLeft, std::vector<char>* inRight) const {
    inLeft->assign(leftMate.size(), 1);
    inRight->assign(rightMate.size(), 0);
    std::vector<int> stack;
    for (int l = 0; l < leftCount(); ++l)
      if (leftMate[l] < 0) {
        (*inLeft)[l] = 0;
        stack.push_back(l);
      }
    while (!stack.empty()) {
      const int l = stack.back();
      stack.pop_back();
      for (int e = p_.start[l]; e < p_.start[l + 1]; ++e) {
        const int r = p_.partner[e];
        if ((*inRight)[r]) continue;
        (*inRight)[r] = 1;
        const int next = rightMate[r];  // matched, or the matching was not maximum
        if (next >= 0 && (*inLeft)[next]) {
          (*inLeft)[next] = 0;
          stack.push_back(next);
        }
      }
    }
  }

 private:
  int leftCount() const { return static_cast<int>(leftMate.size()); }

  void greedy() {
    for (int l = 0; l < leftCount(); ++l)
      for (int e = p_.start[l]; e < p_.start[l + 1] && leftMate[l] < 0; ++e)
        if (rightMate[p_.partner[e]] < 0) {
          leftMate[l] = p_.partner[e];
          rightMate[p_.partner[e]] = l;
        }
  }

  // Breadth-first layers from the free left vertices; true when a free right vertex is reached.
  bool layer() {
    depth_.assign(leftMate.size(), -1);
    next_.assign(p_.start.begin(), p_.start.end() - 1);
    std::vector<int> queue;
    for (int l = 0; l < leftCount(); ++l)
      if (leftMate[l] < 0) {
        depth_[l] = 0;
        queue.push_back(l);
      }
    bool found = false;
    for (std::size_t i = 0; i < queue.size(); ++i) {
      const int l = queue[i];
      for (int e = p_.start[l]; e < p_.start[l + 1]; ++e) {
        const int m = rightMate[p_.partner[e]];
        if (m < 0) {
          found = true;
        } else if (depth_[m] < 0) {
          depth_[m] = depth_[l] + 1;
          queue.push_back(m);
        }
      }
    }
    return found;
  }

  // Depth-first along the layers with an explicit stack; flips the path when it ends free.
  void augment(int root) {
    std::vector<int> path{root};
    while (!path.empty()) {
      const int l = path.back();
      if (next_[l] == p_.start[l + 1]) {
        path.pop_back();
        if (!path.empty()) ++next_[path.back()];
        continue;
      }
      const int r = p_.partner[next_[l]], m = rightMate[r];
      if (m < 0) {
        for (const int k : path) {
          leftMate[k] = p_.partner[next_[k]];
          rightMate[leftMate[k]] = k;
        }
        for (const int k : path) ++next_[k];
        return;
      }
      if (depth_[m] == depth_[l] + 1 && next_[m] < p_.start[m + 1])
        path.push_back(m);
      else
        ++next_[l];
    }
  }

  const CutPairs& p_;
  std::vector<int> depth_, next_;

 public:
  std::vector<int> leftMate, rightMate;
};

}  // namespace

int denseDegree(int vertexCount) {
  return std::max(100, static_cast<int>(10.0 * std::sqrt(static_cast<double>(vertexCount))));
}

void coverCut(const Graph& whole, const Part& part, int width, std::vector<int>* local,
              std::vector<char>* side) {
  for (std::size_t i = 0; i < part.vertex.size(); ++i)
    (*local)[part.vertex[i]] = static_cast<int>(i);
  const CutPairs pairs =
      PairFinder(whole, part, *local, denseDegree(whole.size()), *side).find(width);
  for (const int v : part.vertex) (*local)[v] = -1;
  const Matching matching(pairs);
  std::vector<char> inLeft, inRight;
  matching.coverFromLeft(&inLeft, &inRight);
  for (std::size_t l = 0; l < inLeft.size(); ++l)
    if (inLeft[l]) (*side)[pairs.left[l]] = 2;
  for (std::size_t r = 0; r < inRight.size(); ++r)
    if (inRight[r]) (*side)[pairs.right[r]] = 2;
}

}  // namespace hgp::linalg
