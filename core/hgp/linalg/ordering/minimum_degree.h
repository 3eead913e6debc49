// Minimum degree on small graphs.  Role: orders the leaves of a dissection.
#pragma once

#include <cstdint>
#include <vector>

namespace hgp::linalg {

/// Adjacency of a small graph as rows of bits.
class BitGraph {
 public:
  explicit BitGraph(int size)
      : size_(size), words_((size + 63) / 64), bits_(static_cast<std::size_t>(size) * words_, 0) {}

  int size() const { return size_; }
  int words() const { return words_; }
  std::uint64_t* row(int v) { return bits_.data() + static_cast<std::size_t>(v) * words_; }
  void connect(int a, int b) {
    if (a == b) return;
    row(a)[b >> 6] |= std::uint64_t{1} << (b & 63);
    row(b)[a >> 6] |= std::uint64_t{1} << (a & 63);
  }

 private:
  int size_, words_;
  std::vector<std::uint64_t> bits_;
};

/// Eliminates vertices 0 … count − 1, fewest neighbours first (ties: smallest index); the others, the
/// halo, remain and count as neighbours. Returns the elimination order; `graph` is modified.
std::vector<int> minimumDegreeOrder(BitGraph* graph, int count);

}  // namespace hgp::linalg
