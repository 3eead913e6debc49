// Exact arithmetic on products of 64-bit integers.  Role: the numbers of the exact predicates, the same with every
// compiler. The CMake option HGP_PORTABLE restricts the code to ISO C++.
#pragma once

#include <compare>
#include <cstdint>

namespace hgp {

/// high · 2^64 + low
struct UnsignedProduct {
  std::uint64_t high = 0, low = 0;
  friend constexpr bool operator==(const UnsignedProduct&, const UnsignedProduct&) = default;
};

/// a b, exactly, from products of 32-bit halves, in ISO C++.
constexpr UnsignedProduct multiplyByHalves(std::uint64_t a, std::uint64_t b) {
  constexpr std::uint64_t kMask = 0xffffffffu;
  const std::uint64_t aLow = a & kMask, aHigh = a >> 32, bLow = b & kMask, bHigh = b >> 32;
  const std::uint64_t low = aLow * bLow;
  const std::uint64_t first = aHigh * bLow + (low >> 32);  // at most 2^64 − 2^32
  const std::uint64_t second = aLow * bHigh + (first & kMask);
  return {aHigh * bHigh + (first >> 32) + (second >> 32), (second << 32) | (low & kMask)};
}

/// a b, exactly, by the fastest means that the compiler has.
constexpr UnsignedProduct multiply(std::uint64_t a, std::uint64_t b) {
#if defined(__SIZEOF_INT128__) && !defined(HGP_PORTABLE)
  __extension__ typedef unsigned __int128 Native;
  const Native product = static_cast<Native>(a) * b;
  return {static_cast<std::uint64_t>(product >> 64), static_cast<std::uint64_t>(product)};
#else
  return multiplyByHalves(a, b);
#endif
}

/// A signed integer of 128 bits in two's complement. Products of 64-bit integers fit, and so do sums and
/// differences of two of them unless all four factors are −2^63; larger sums wrap around.
class WideInteger {
 public:
  constexpr WideInteger() = default;

  /// a b
  static constexpr WideInteger product(std::int64_t a, std::int64_t b) {
    const auto magnitude = [](std::int64_t x) {
      const auto bits = static_cast<std::uint64_t>(x);
      return x < 0 ? 0 - bits : bits;
    };
    const UnsignedProduct p = multiply(magnitude(a), magnitude(b));
    const WideInteger positive(p.high, p.low);
    return (a < 0) != (b < 0) ? WideInteger() - positive : positive;
  }

  friend constexpr WideInteger operator+(const WideInteger& a, const WideInteger& b) {
    const std::uint64_t low = a.low_ + b.low_;
    return {a.high_ + b.high_ + (low < a.low_), low};
  }
  friend constexpr WideInteger operator-(const WideInteger& a, const WideInteger& b) {
    return {a.high_ - b.high_ - (a.low_ < b.low_), a.low_ - b.low_};
  }

  /// −1, 0 or 1
  constexpr int sign() const { return high_ >> 63 ? -1 : (high_ | low_) != 0; }

  friend constexpr bool operator==(const WideInteger&, const WideInteger&) = default;
  friend constexpr std::strong_ordering operator<=>(const WideInteger& a, const WideInteger& b) {
    const auto highA = static_cast<std::int64_t>(a.high_),
               highB = static_cast<std::int64_t>(b.high_);
    return highA != highB ? highA <=> highB : a.low_ <=> b.low_;
  }

  /// The upper and the lower 64 bits.
  constexpr std::uint64_t high() const { return high_; }
  constexpr std::uint64_t low() const { return low_; }

 private:
  constexpr WideInteger(std::uint64_t high, std::uint64_t low) : high_(high), low_(low) {}
  std::uint64_t high_ = 0, low_ = 0;
};

}  // namespace hgp
