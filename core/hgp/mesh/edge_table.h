// The sides of every edge of a triangle soup, manifold or not.  Role: connectivity for finding and
// repairing defects.
#pragma once

#include <array>
#include <vector>

namespace hgp {

/// Sides 3f + k (from corner k to corner k + 1 of face f) grouped by their undirected edge.
class EdgeTable {
 public:
  /// Faces with isSkipped ≠ 0 have no sides here; the others have three different vertices in
  /// range. O(|F|) but for sorting within a vertex.
  EdgeTable(const std::vector<std::array<int, 3>>& triangles, const std::vector<char>& isSkipped,
            int vertexCount);

  int edgeCount() const { return static_cast<int>(start_.size()) - 1; }
  /// The sides of edge e, ascending.
  const int* begin(int e) const { return sides_.data() + start_[static_cast<std::size_t>(e)]; }
  const int* end(int e) const { return sides_.data() + start_[static_cast<std::size_t>(e) + 1]; }
  int faceCount(int e) const { return static_cast<int>(end(e) - begin(e)); }
  /// The two vertices, smaller first.
  std::array<int, 2> vertices(int e) const { return vertices_[static_cast<std::size_t>(e)]; }

 private:
  std::vector<int> sides_;
  std::vector<int> start_;
  std::vector<std::array<int, 2>> vertices_;
};

/// The next corner of the same face.
constexpr int nextSide(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

/// Vertex at the start of a side.
inline int sideTail(const std::vector<std::array<int, 3>>& triangles, int side) {
  return triangles[static_cast<std::size_t>(side / 3)][static_cast<std::size_t>(side % 3)];
}

}  // namespace hgp
