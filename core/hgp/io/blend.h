// Weighted means of stored values.  Role: the one rule by which attributes of new vertices follow from old ones, for halves of
// edges and for points of triangles alike.
#pragma once

#include <array>
#include <map>
#include <vector>

namespace hgp::io {

/// Σ weight[i] · value[of[i]]: indices ascend, weights are positive and have the sum 1; −1 behind the last. The same point of an
/// edge gives the same bits from both of its triangles.
struct Blend {
  std::array<int, 3> of{-1, -1, -1};
  std::array<double, 3> weight{};
  friend bool operator==(const Blend&, const Blend&) = default;
  friend bool operator<(const Blend& a, const Blend& b) {
    return a.of != b.of ? a.of < b.of : a.weight < b.weight;
  }

  bool isOne() const { return of[0] >= 0 && of[1] < 0; }
};

/// Weights of equal indices are added, those of weight 0 left out. No index at all where one that counts is −1.
Blend blendOf(const std::array<int, 3>& of, const std::array<double, 3>& weight);

template <std::size_t N>
std::array<double, N> blended(const Blend& blend,
                              const std::vector<std::array<double, N>>& values) {
  std::array<double, N> out{};
  for (std::size_t i = 0; i < 3 && blend.of[i] >= 0; ++i)
    for (std::size_t k = 0; k < N; ++k)
      out[k] += blend.weight[i] * values[static_cast<std::size_t>(blend.of[i])][k];
  return out;
}

/// A number for each different blend, in the order of their first use.
class BlendTable {
 public:
  /// −1 for a blend of nothing.
  int of(const Blend& blend);
  const std::vector<Blend>& blends() const { return blends_; }

 private:
  std::map<Blend, int> found_;
  std::vector<Blend> blends_;
};

}  // namespace hgp::io
