// Random numbers that are the same everywhere.  Role: fixed seeds mean fixed tests.
#pragma once

#include <random>

namespace hgp::test {

/// Not the distributions of <random>: their values differ between standard libraries.
inline int randomBelow(std::mt19937& random, int n) {
  return static_cast<int>(random() % static_cast<unsigned>(n));
}
/// In [−1, 1).
inline double randomReal(std::mt19937& random) {
  return 2.0 * (static_cast<double>(random()) / 4294967296.0) - 1.0;
}

}  // namespace hgp::test
