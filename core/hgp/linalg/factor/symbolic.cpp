#include "hgp/linalg/factor/symbolic.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/linalg/factor/elimination_tree.h"

namespace hgp::linalg {
namespace {

double multiplyAdds(double s, double r) {
  return s * s * s / 6.0 + s * s * r / 2.0 + s * r * r / 2.0;
}

// Estimated nanoseconds to assemble and eliminate a panel of s pivots and r further rows. Only the
// ratios matter: fixed cost per node, traffic of the contribution block, thin panels run slower.
double nodeTime(double s, double r) {
  return 200.0 + (s + r) + s * (s + r) + 0.5 * r * r + 0.2 * multiplyAdds(s, r) * (1.0 + 4.0 / s);
}

std::vector<int> inverse(const std::vector<int>& permutation) {
  std::vector<int> result(permutation.size(), -1);
  for (std::size_t k = 0; k < permutation.size(); ++k) result[permutation[k]] = static_cast<int>(k);
  return result;
}

// Nodes under construction: ranges of columns of the first postordering, merged upwards.
struct NodeForest {
  std::vector<int> firstColumn;  // node t is columns firstColumn[t] … firstColumn[t + 1] − 1
  std::vector<int> parent;
  std::vector<char> dynamic;
  std::vector<int> pivots, height;  // after merging: s and s + r
  std::vector<int> mergedInto;      // −1 for a node that has not been merged
};

struct ColumnForest {
  std::vector<int> order, position, parent, count;
  std::vector<char> dynamic;
};

ColumnForest columnForest(const Graph& pattern, const std::vector<int>& order,
                          const std::vector<char>& dynamic) {
  ColumnForest f;
  const std::vector<int> parent = eliminationTree(pattern, order, inverse(order));
  const std::vector<int> visited = postorder(parent);
  const std::vector<int> newName = inverse(visited);
  f.order.resize(order.size());
  f.parent.resize(order.size());
  f.dynamic.assign(order.size(), 0);
  for (std::size_t k = 0; k < order.size(); ++k) {
    f.order[k] = order[visited[k]];
    f.parent[k] = parent[visited[k]] < 0 ? -1 : newName[parent[visited[k]]];
    if (!dynamic.empty() && dynamic[f.order[k]]) f.dynamic[k] = 1;
    if (f.dynamic[k] && f.parent[k] >= 0) f.dynamic[f.parent[k]] = 1;
  }
  f.position = inverse(f.order);
  f.count = columnCounts(pattern, f.order, f.position, f.parent);
  return f;
}

NodeForest fundamentalNodes(const ColumnForest& f) {
  NodeForest nodes;
  const int n = static_cast<int>(f.order.size());
  std::vector<int> nodeOf(f.order.size());
  for (int k = 0; k < n; ++k) {
    const bool joins = k > 0 && f.parent[k - 1] == k && f.count[k - 1] == f.count[k] + 1 &&
                       f.dynamic[k - 1] == f.dynamic[k];
    if (!joins) {
      nodes.firstColumn.push_back(k);
      nodes.dynamic.push_back(f.dynamic[k]);
      nodes.height.push_back(f.count[k]);
    }
    nodeOf[k] = static_cast<int>(nodes.firstColumn.size()) - 1;
  }
  const int count = static_cast<int>(nodes.firstColumn.size());
  nodes.firstColumn.push_back(n);
  for (int t = 0; t < count; ++t) {
    const int up = f.parent[nodes.firstColumn[t + 1] - 1];
    nodes.parent.push_back(up < 0 ? -1 : nodeOf[up]);
    nodes.pivots.push_back(nodes.firstColumn[t + 1] - nodes.firstColumn[t]);
  }
  nodes.mergedInto.assign(static_cast<std::size_t>(count), -1);
  return nodes;
}

// Bottom up: each node absorbs the children whose merging saves time, tallest child first.
void amalgamate(NodeForest* nodes) {
  const int count = static_cast<int>(nodes->parent.size());
  std::vector<std::vector<int>> children(static_cast<std::size_t>(count));
  for (int p = 0; p < count; ++p) {
    std::vector<int> mine = std::move(children[p]);
    std::stable_sort(mine.begin(), mine.end(),
                     [&](int a, int b) { return nodes->height[a] > nodes->height[b]; });
    for (const int c : mine) {
      if (nodes->dynamic[c] != nodes->dynamic[p]) continue;
      const double sp = nodes->pivots[p], sc = nodes->pivots[c];
      const double rp = nodes->height[p] - sp, rc = nodes->height[c] - sc;
      if (nodeTime(sp + sc, rp) >= nodeTime(sp, rp) + nodeTime(sc, rc)) continue;
      nodes->mergedInto[c] = p;
      nodes->pivots[p] += nodes->pivots[c];
      nodes->height[p] += nodes->pivots[c];
    }
    if (nodes->parent[p] >= 0) children[nodes->parent[p]].push_back(p);
  }
}

// Numbers the surviving nodes in postorder; the columns of a node keep their relative order.
void numberNodes(const ColumnForest& f, const NodeForest& nodes, SymbolicFactor* out) {
  const int count = static_cast<int>(nodes.parent.size());
  std::vector<int> head(nodes.mergedInto), up(nodes.parent);
  for (int t = count - 1; t >= 0; --t) head[t] = head[t] < 0 ? t : head[head[t]];
  std::vector<std::vector<int>> members(static_cast<std::size_t>(count));
  for (int t = 0; t < count; ++t) {
    members[head[t]].push_back(t);
    up[t] = up[t] < 0 ? -1 : head[up[t]];
  }
  // Merged nodes become leaves below the node that absorbed them, so one postorder visits all of these in order.
  const std::vector<int> visited = postorder(up);
  std::vector<int> name(static_cast<std::size_t>(count), -1);
  out->nodeStart.push_back(0);
  out->order.reserve(f.order.size());
  for (const int t : visited) {
    if (head[t] != t) continue;
    name[t] = out->nodeCount();
    out->parent.push_back(up[t]);
    out->dynamicNode.push_back(nodes.dynamic[t]);
    for (const int m : members[t])
      out->order.insert(out->order.end(), f.order.begin() + nodes.firstColumn[m],
                        f.order.begin() + nodes.firstColumn[m + 1]);
    out->nodeStart.push_back(static_cast<int>(out->order.size()));
  }
  for (int& p : out->parent) p = p < 0 ? -1 : name[p];
}

void buildRows(const Graph& pattern, SymbolicFactor* out) {
  std::vector<std::vector<int>> children(out->parent.size());
  std::vector<int> seen(out->order.size(), -1);
  out->rowStart.push_back(0);
  for (int t = 0; t < out->nodeCount(); ++t) {
    const int end = out->nodeStart[t + 1];
    const auto add = [&](int row) {
      if (row < end || seen[row] == t) return;
      seen[row] = t;
      out->rows.push_back(row);
    };
    for (const int c : children[t])
      for (std::int64_t e = out->rowStart[c]; e < out->rowStart[c + 1]; ++e)
        add(out->rows[static_cast<std::size_t>(e)]);
    for (int k = out->nodeStart[t]; k < end; ++k) {
      const int v = out->order[k];
      for (const int* u = pattern.begin(v); u != pattern.end(v); ++u) add(out->position[*u]);
    }
    std::sort(out->rows.begin() + out->rowStart[t], out->rows.end());
    out->rowStart.push_back(static_cast<std::int64_t>(out->rows.size()));
    children[t] = {};
    if (out->parent[t] >= 0) children[out->parent[t]].push_back(t);
  }
}

}  // namespace

SymbolicFactor analyze(const Graph& pattern, const std::vector<int>& order,
                       const SymbolicOptions& options) {
  HGP_CHECK(static_cast<int>(order.size()) == pattern.size(), "order of %d for %d unknowns",
            static_cast<int>(order.size()), pattern.size());
  const ColumnForest columns = columnForest(pattern, order, options.dynamic);
  NodeForest nodes = fundamentalNodes(columns);
  if (options.amalgamate) amalgamate(&nodes);
  SymbolicFactor result;
  numberNodes(columns, nodes, &result);
  result.position = inverse(result.order);
  std::int64_t rowTotal = 0;
  for (std::size_t t = 0; t < nodes.parent.size(); ++t)
    if (nodes.mergedInto[t] < 0) rowTotal += nodes.height[t] - nodes.pivots[t];
  result.rows.reserve(static_cast<std::size_t>(rowTotal));
  buildRows(pattern, &result);
  return result;
}

std::vector<double> nodeTimes(const SymbolicFactor& symbolic, int nodeClass) {
  std::vector<double> times(symbolic.parent.size(), -1.0);
  for (int t = 0; t < symbolic.nodeCount(); ++t)
    if (nodeClass < 0 || symbolic.dynamicNode[t] == nodeClass)
      times[t] = nodeTime(symbolic.pivots(t), symbolic.rowCount(t));
  return times;
}

FactorCost factorCost(const SymbolicFactor& symbolic, int dynamicClass) {
  FactorCost cost;
  std::vector<std::int64_t> waiting(symbolic.parent.size(),
                                    0);  // entries of contributions to a node
  std::int64_t live = 0, peak = 0;
  for (int t = 0; t < symbolic.nodeCount(); ++t) {
    if (dynamicClass >= 0 && symbolic.dynamicNode[t] != dynamicClass) continue;
    const std::int64_t s = symbolic.pivots(t), r = symbolic.rowCount(t);
    cost.multiplyAdds += multiplyAdds(static_cast<double>(s), static_cast<double>(r));
    cost.entries += s * (s + r);
    live += s * (s + r) + r * r;
    peak = std::max(peak, live);
    live -= waiting[t];
    if (symbolic.parent[t] >= 0) waiting[symbolic.parent[t]] += r * r;
  }
  cost.peakEntries = peak;
  return cost;
}

}  // namespace hgp::linalg
