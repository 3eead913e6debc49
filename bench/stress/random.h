// Random numbers that are the same on every machine.  Role: a draw is identified by its name, "7/random/ring
// 3/0", and can be reproduced alone.
#pragma once

#include <cstdint>
#include <string_view>

namespace hgp::stress {

/// SplitMix64, seeded with a hash (FNV-1a) of a name.
class Random {
 public:
  explicit Random(std::string_view name) {
    for (const char c : name) state_ = (state_ ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }

  std::uint64_t bits() {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  /// In [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// In [a, b).
  double between(double a, double b) { return a + (b - a) * unit(); }
  /// In {0, …, n − 1}; n ≥ 1.
  int below(int n) { return static_cast<int>(bits() % static_cast<std::uint64_t>(n)); }

 private:
  std::uint64_t state_ = 0xcbf29ce484222325ULL;
};

}  // namespace hgp::stress
