#include "hgp/api/sha256.h"

#include <array>
#include <bit>
#include <cstring>

namespace hgp::api {
namespace {

constexpr std::array<std::uint32_t, 64> kConstants = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using Hash = std::array<std::uint32_t, 8>;

/// One round of the standard; the new first value is left in h and the new fifth value in d.
[[gnu::always_inline]] inline void turn(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                        std::uint32_t& d, std::uint32_t e, std::uint32_t f,
                                        std::uint32_t g, std::uint32_t& h, std::uint32_t added) {
  const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
  const std::uint32_t first = h + s1 + (g ^ (e & (f ^ g))) + added;
  const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
  d += first;
  h = first + s0 + ((a & b) | (c & (a | b)));
}

/// Not inlined: WebAssembly engines switch to optimized code between calls, not inside a running loop.
[[gnu::noinline]] void addBlock(Hash& hash, const std::uint8_t* block) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t i = 0; i < 16; ++i) {
    w[i] = static_cast<std::uint32_t>(block[4 * i]) << 24 |
           static_cast<std::uint32_t>(block[4 * i + 1]) << 16 |
           static_cast<std::uint32_t>(block[4 * i + 2]) << 8 |
           static_cast<std::uint32_t>(block[4 * i + 3]);
  }
  for (std::size_t i = 16; i < 64; ++i) {
    const std::uint32_t a = w[i - 15], b = w[i - 2];
    w[i] = w[i - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[i - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
  }
  // Scalars instead of an array, which clang vectorizes into code that is ten times slower.
  std::uint32_t h0 = hash[0], h1 = hash[1], h2 = hash[2], h3 = hash[3];
  std::uint32_t h4 = hash[4], h5 = hash[5], h6 = hash[6], h7 = hash[7];
  for (std::size_t i = 0; i < 64; i += 8) {  // arguments rotate instead of values
    turn(h0, h1, h2, h3, h4, h5, h6, h7, kConstants[i] + w[i]);
    turn(h7, h0, h1, h2, h3, h4, h5, h6, kConstants[i + 1] + w[i + 1]);
    turn(h6, h7, h0, h1, h2, h3, h4, h5, kConstants[i + 2] + w[i + 2]);
    turn(h5, h6, h7, h0, h1, h2, h3, h4, kConstants[i + 3] + w[i + 3]);
    turn(h4, h5, h6, h7, h0, h1, h2, h3, kConstants[i + 4] + w[i + 4]);
    turn(h3, h4, h5, h6, h7, h0, h1, h2, kConstants[i + 5] + w[i + 5]);
    turn(h2, h3, h4, h5, h6, h7, h0, h1, kConstants[i + 6] + w[i + 6]);
    turn(h1, h2, h3, h4, h5, h6, h7, h0, kConstants[i + 7] + w[i + 7]);
  }
  const Hash added = {h0, h1, h2, h3, h4, h5, h6, h7};
  for (std::size_t i = 0; i < 8; ++i) hash[i] += added[i];
}

}  // namespace

std::string sha256(const std::uint8_t* bytes, std::size_t size) {
  Hash hash = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
               0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::size_t done = 0;
  for (; size - done >= 64; done += 64) addBlock(hash, bytes + done);
  std::array<std::uint8_t, 128> tail{};
  const std::size_t rest = size - done;
  if (rest > 0) std::memcpy(tail.data(), bytes + done, rest);
  tail[rest] = 0x80;
  const std::size_t padded = rest < 56 ? 64 : 128;
  const std::uint64_t bitCount = static_cast<std::uint64_t>(size) * 8;
  for (std::size_t i = 0; i < 8; ++i) {
    tail[padded - 1 - i] = static_cast<std::uint8_t>(bitCount >> (8 * i));
  }
  for (std::size_t i = 0; i < padded; i += 64) addBlock(hash, tail.data() + i);
  std::string text;
  for (std::uint32_t word : hash) {
    for (int shift = 28; shift >= 0; shift -= 4) text += "0123456789abcdef"[(word >> shift) & 15];
  }
  return text;
}

}  // namespace hgp::api
