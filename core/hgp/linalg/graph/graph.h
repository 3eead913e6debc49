// Undirected graphs as adjacency lists.  Role: input of the orderings and the symbolic analysis.
#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace hgp::linalg {

/// Neighbours of v are neighbours[start[v]] … neighbours[start[v + 1] − 1]: each edge is listed at
/// both ends, no loops, no duplicates, any order.
struct Graph {
  std::vector<int> start{0};
  std::vector<int> neighbours;

  int size() const { return static_cast<int>(start.size()) - 1; }
  int degree(int v) const { return start[v + 1] - start[v]; }
  const int* begin(int v) const { return neighbours.data() + start[v]; }
  const int* end(int v) const { return neighbours.data() + start[v + 1]; }
};

/// Index lists whose members are pairwise coupled (the unknowns of one small dense block).
using Cliques = std::vector<std::vector<int>>;

/// The off-diagonal pattern of a square matrix, made symmetric (entries of one triangle suffice).
template <class Scalar>
Graph graphOf(const Eigen::SparseMatrix<Scalar>& matrix);

/// Of these pairs of different vertices, each in either order and as often as one likes.
Graph graphOf(int vertexCount, const std::vector<std::array<int, 2>>& edges);

/// `graph` plus an edge between any two members of a clique.
Graph withCliques(const Graph& graph, const Cliques& cliques);

}  // namespace hgp::linalg
