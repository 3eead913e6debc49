#include "hgp/base/wide_integer.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace hgp {
namespace {

/// The ends of the range, powers of two with their neighbours, and numbers of every length.
std::vector<std::uint64_t> sampleNumbers() {
  std::vector<std::uint64_t> out = {0};
  for (int bit = 0; bit < 64; ++bit)
    for (const int more : {-1, 0, 1})
      out.push_back((std::uint64_t{1} << bit) + static_cast<std::uint64_t>(more));
  std::mt19937_64 random(41);
  for (int n = 0; n < 200; ++n) out.push_back(random() >> (n % 64));
  return out;
}

TEST(WideInteger, ProductsByHalvesAgreeWithLongMultiplication) {
  EXPECT_EQ(multiplyByHalves(3, 5), (UnsignedProduct{0, 15}));
  EXPECT_EQ(multiplyByHalves(~0ull, ~0ull), (UnsignedProduct{~1ull, 1}));
  EXPECT_EQ(multiplyByHalves(1ull << 63, 6), (UnsignedProduct{3, 0}));
  EXPECT_EQ(multiplyByHalves(0xfedcba9876543210u, 0x123456789abcdef0u),
            (UnsignedProduct{0x121fa00ad77d7422u, 0x236d88fe5618cf00u}));
}

TEST(WideInteger, BothWaysToAProductAgree) {
  const std::vector<std::uint64_t> numbers = sampleNumbers();
  for (const std::uint64_t a : numbers)
    for (const std::uint64_t b : numbers)
      ASSERT_EQ(multiply(a, b), multiplyByHalves(a, b)) << a << " " << b;
}

#ifdef __SIZEOF_INT128__
__extension__ typedef __int128 Native;
__extension__ typedef unsigned __int128 UnsignedNative;

Native native(const WideInteger& x) {
  return static_cast<Native>(static_cast<UnsignedNative>(x.high()) << 64 | x.low());
}

TEST(WideInteger, ProductsSumsAndOrderAreThoseOfTheCompilersOwnType) {
  const std::vector<std::uint64_t> bits = sampleNumbers();
  std::mt19937_64 random(43);
  const auto any = [&] { return static_cast<std::int64_t>(bits[random() % bits.size()]); };
  for (int round = 0; round < 200000; ++round) {
    const std::int64_t a = any(), b = any(), c = any(), d = round % 7 == 0 ? b : any();
    const WideInteger x = WideInteger::product(a, b);
    const WideInteger y = WideInteger::product(round % 7 == 0 ? a : c, d);
    const Native p = static_cast<Native>(a) * b;
    const Native q = static_cast<Native>(round % 7 == 0 ? a : c) * d;
    ASSERT_TRUE(native(x) == p) << a << " " << b;
    ASSERT_EQ(x.sign(), p > 0 ? 1 : p < 0 ? -1 : 0);
    ASSERT_EQ(x < y, p < q);
    ASSERT_EQ(x <= y, p <= q);
    ASSERT_EQ(x == y, p == q);
    const auto wrapped = [](Native s, Native t, bool isSum) {
      const auto u = static_cast<UnsignedNative>(s), v = static_cast<UnsignedNative>(t);
      return static_cast<Native>(isSum ? u + v : u - v);
    };
    ASSERT_TRUE(native(x - y) == wrapped(p, q, false)) << a << " " << b << " " << c << " " << d;
    ASSERT_TRUE(native(x + y) == wrapped(p, q, true)) << a << " " << b << " " << c << " " << d;
  }
}
#endif

}  // namespace
}  // namespace hgp
