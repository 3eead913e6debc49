// Integers of the q-th cyclotomic ring, Σ n_r ζ^r with ζ = e^{i2π/q}.  Role: rotations by multiples of 2π/q, exactly,
// for every q; where Z[i] or Z[ω] contains them, those are used.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

class Cyclotomic {
 public:
  static constexpr bool kIsEuclidean = false;

  Cyclotomic() = default;  ///< 0, of every order
  /// ζ^r; `order` is q.
  static Cyclotomic turned(long long r, int order);

  friend Cyclotomic operator+(const Cyclotomic& a, const Cyclotomic& b);
  friend Cyclotomic operator-(const Cyclotomic& a, const Cyclotomic& b) { return a + (-b); }
  friend Cyclotomic operator-(const Cyclotomic& a);
  friend Cyclotomic operator*(const Cyclotomic& a, const Cyclotomic& b);
  /// The same number: the representation is not unique, as 1 + ζ + … + ζ^{q−1} = 0.
  friend bool operator==(const Cyclotomic& a, const Cyclotomic& b) { return isZero(a - b); }

  friend Cyclotomic conjugate(const Cyclotomic& a);
  /// Exact: in Z[x]/(x^q − 1), a is 0 at the primitive roots of unity if and only if a · Π (x^{q/p} − 1) = 0, over
  /// the primes p that divide q.
  friend bool isZero(const Cyclotomic& a);
  /// ±ζ^r; the ring has other units, which are not looked for.
  friend bool isUnit(const Cyclotomic& a);
  /// Σ n_r², 1 exactly for what isUnit finds; a bound of the coefficients.
  friend std::int64_t norm(const Cyclotomic& a);
  friend Complex toComplex(const Cyclotomic& a);

 private:
  void add(int power, std::int64_t count);

  int q_ = 0;
  /// (r, n_r), ascending, n_r ≠ 0; for even q only r < q/2, as ζ^{q/2} = −1.
  std::vector<std::pair<int, std::int64_t>> terms_;
};

}  // namespace hgp
