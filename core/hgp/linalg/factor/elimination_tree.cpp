#include "hgp/linalg/factor/elimination_tree.h"

#include <algorithm>

namespace hgp::linalg {

std::vector<int> eliminationTree(const Graph& pattern, const std::vector<int>& order,
                                 const std::vector<int>& position) {
  const int n = pattern.size();
  std::vector<int> parent(static_cast<std::size_t>(n), -1), ancestor(parent);
  for (int k = 0; k < n; ++k) {
    const int v = order[k];
    for (const int* u = pattern.begin(v); u != pattern.end(v); ++u) {
      int i = position[*u];
      if (i > k) continue;
      while (ancestor[i] >= 0 && ancestor[i] != k) {
        const int up = ancestor[i];
        ancestor[i] = k;
        i = up;
      }
      if (ancestor[i] < 0) {
        ancestor[i] = k;
        parent[i] = k;
      }
    }
  }
  return parent;
}

std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> firstChild(parent.size(), -1), sibling(parent.size(), -1);
  int firstRoot = -1;
  for (int v = n - 1; v >= 0; --v) {
    int& head = parent[v] < 0 ? firstRoot : firstChild[parent[v]];
    sibling[v] = head;
    head = v;
  }
  std::vector<int> visited, stack;
  visited.reserve(parent.size());
  for (int root = firstRoot; root >= 0; root = sibling[root]) {
    stack.push_back(root);
    while (!stack.empty()) {
      const int v = stack.back();
      const int child = firstChild[v];
      if (child >= 0) {
        firstChild[v] = sibling[child];
        stack.push_back(child);
      } else {
        visited.push_back(v);
        stack.pop_back();
      }
    }
  }
  return visited;
}

namespace {

// Root of v's tree among the subtrees linked so far, with path halving.
int findTop(std::vector<int>* up, int v) {
  std::vector<int>& a = *up;
  while (a[v] != v) {
    a[v] = a[a[v]];
    v = a[v];
  }
  return v;
}

// First node, in postorder, of each subtree.
std::vector<int> firstDescendants(const std::vector<int>& parent) {
  std::vector<int> first(parent.size(), 0);
  const int n = static_cast<int>(parent.size());
  for (int j = 0; j < n; ++j) first[j] = j;
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) first[parent[j]] = std::min(first[parent[j]], first[j]);
  return first;
}

}  // namespace

// The count of column j is the number of row subtrees that contain j. The indicator of a subtree with
// leaves l1 … lk (in postorder) and root i is a sum over descendants of +1 at each leaf, −1 at the
// lowest common ancestor of consecutive leaves and −1 at the parent of i.
std::vector<int> columnCounts(const Graph& pattern, const std::vector<int>& order,
                              const std::vector<int>& position, const std::vector<int>& parent) {
  const int n = pattern.size();
  const std::vector<int> firstDescendant = firstDescendants(parent);
  std::vector<int> count(parent.size(), 0), top(parent.size(), 0);
  std::vector<int> latestFirst(parent.size(), -1), previousLeaf(parent.size(), -1);
  for (int j = 0; j < n; ++j) {
    top[j] = j;
    if (firstDescendant[j] == j) count[j] = 1;  // a leaf of the tree
  }
  for (int j = 0; j < n; ++j) {
    if (parent[j] >= 0) --count[parent[j]];
    const int v = order[j];
    for (const int* u = pattern.begin(v); u != pattern.end(v); ++u) {
      const int i = position[*u];
      if (i < j || firstDescendant[j] <= latestFirst[i]) continue;
      ++count[j];
      if (previousLeaf[i] >= 0) --count[findTop(&top, previousLeaf[i])];
      latestFirst[i] = firstDescendant[j];
      previousLeaf[i] = j;
    }
    if (parent[j] >= 0) top[j] = parent[j];
  }
  for (int j = 0; j < n; ++j)
    if (parent[j] >= 0) count[parent[j]] += count[j];
  return count;
}

}  // namespace hgp::linalg
