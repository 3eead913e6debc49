#include "hgp/verify/orientation.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstdint>

#include "hgp/base/wide_integer.h"

namespace hgp {
namespace {

/// A finite double as (−1)^isNegative · magnitude · 2^exponent, exactly.
struct Parts {
  std::uint64_t magnitude;
  int exponent;
  bool isNegative;
};

Parts split(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);  // handles denormals
  return {static_cast<std::uint64_t>(std::ldexp(std::fabs(fraction), DBL_MANT_DIG)),
          exponent - DBL_MANT_DIG, std::signbit(x)};
}

/// An exact sum of products of doubles: two's complement fixed point, as many words as the spread of
/// the exponents asks for. Nothing can underflow or overflow.
class ProductSum {
 public:
  void add(double a, double b, bool isSubtracted) {
    const Parts p = split(a), q = split(b);
    if (p.magnitude == 0 || q.magnitude == 0) return;
    terms_[count_++] = {multiply(p.magnitude, q.magnitude), p.exponent + q.exponent,
                        (p.isNegative != q.isNegative) != isSubtracted};
  }

  int sign() const {
    if (count_ == 0) return 0;
    std::uint64_t words[kMaxWords] = {};
    const int wordCount = total(words, lowestExponent());
    if (words[wordCount - 1] >> 63) return -1;
    for (int w = 0; w < wordCount; ++w)
      if (words[w] != 0) return 1;
    return 0;
  }

  /// To a relative error of 2^−52; 0 and infinity where doubles end.
  double value() const {
    if (count_ == 0) return 0.0;
    std::uint64_t words[kMaxWords] = {};
    const int lowest = lowestExponent(), wordCount = total(words, lowest);
    const bool isNegative = words[wordCount - 1] >> 63;
    std::uint64_t carry = isNegative ? 1 : 0;
    for (int w = 0; w < wordCount; ++w) {
      words[w] = (isNegative ? ~words[w] : words[w]) + carry;
      carry = carry && words[w] == 0;
    }
    int top = wordCount - 1;
    while (top > 0 && words[top] == 0) --top;
    double leading = static_cast<double>(words[top]);
    if (top > 0) leading += std::ldexp(static_cast<double>(words[top - 1]), -64);
    if (top > 1) leading += std::ldexp(static_cast<double>(words[top - 2]), -128);
    const double size = std::ldexp(leading, lowest + 64 * top);
    return isNegative ? -size : size;
  }

 private:
  struct Term {
    UnsignedProduct magnitude;
    int exponent;
    bool isNegative;
  };
  // Product exponents lie between −2148 and 1942.
  static constexpr int kMaxWords = (1942 + 2148 + 110) / 64 + 1;

  int lowestExponent() const {
    int lowest = terms_[0].exponent;
    for (int n = 1; n < count_; ++n) lowest = std::min(lowest, terms_[n].exponent);
    return lowest;
  }

  /// The sum in units of 2^lowest. Returns how many words it takes.
  int total(std::uint64_t* words, int lowest) const {
    int highest = lowest;
    for (int n = 0; n < count_; ++n) highest = std::max(highest, terms_[n].exponent);
    // 106 bits of a product, 3 for six terms, 1 for the sign.
    const int wordCount = (highest - lowest + 110) / 64 + 1;
    for (int n = 0; n < count_; ++n)
      accumulate(words, wordCount, terms_[n], terms_[n].exponent - lowest);
    return wordCount;
  }

  static void accumulate(std::uint64_t* words, int wordCount, const Term& term, int shift) {
    const int offset = shift % 64;
    const auto [high, low] = term.magnitude;
    const std::uint64_t piece[3] = {low << offset,
                                    offset ? (low >> (64 - offset)) | (high << offset) : high,
                                    offset ? high >> (64 - offset) : 0};
    // −x = ~x + 1, so a negative term adds the complement of its pieces and of the zeros around.
    std::uint64_t carry = term.isNegative ? 1 : 0;
    for (int w = shift / 64, n = 0; w < wordCount; ++w, ++n) {
      const std::uint64_t plain = n < 3 ? piece[n] : 0, digit = term.isNegative ? ~plain : plain;
      const std::uint64_t sum = words[w] + digit, whole = sum + carry;
      carry = (sum < digit) + (whole < sum);
      words[w] = whole;
    }
  }

  Term terms_[6] = {};
  int count_ = 0;
};

/// Four roundings of relative size 2^−53 stand between the determinant and its computed value.
constexpr double kFilter = 4.0 * (DBL_EPSILON / 2);

/// (b − a) × (c − a), multiplied out: a × a cancels.
ProductSum crossProduct(const Vec2& a, const Vec2& b, const Vec2& c) {
  ProductSum sum;
  sum.add(b[0], c[1], false);
  sum.add(b[0], a[1], true);
  sum.add(a[0], c[1], true);
  sum.add(b[1], c[0], true);
  sum.add(b[1], a[0], false);
  sum.add(a[1], c[0], false);
  return sum;
}

}  // namespace

int exactOrientationSign(const Vec2& a, const Vec2& b, const Vec2& c) {
  return crossProduct(a, b, c).sign();
}

double exactTwiceArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return crossProduct(a, b, c).value();
}

int orientationSign(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b[0] - a[0]) * (c[1] - a[1]);
  const double right = (b[1] - a[1]) * (c[0] - a[0]);
  const double det = left - right;
  // A product that underflows has an error below DBL_MIN; one that overflows makes the bound infinite
  // or det NaN, and then both comparisons are false.
  const double bound = kFilter * (std::fabs(left) + std::fabs(right)) + 2 * DBL_MIN;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  return exactOrientationSign(a, b, c);
}

OrientationFacts measureOrientation(const TriMesh& mesh, const PerVertex<char>& isCone,
                                    const CornerUv& uv) {
  OrientationFacts facts;
  for (FaceId f : mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    const int sign = orientationSign(uv[h], uv[TriMesh::next(h)], uv[TriMesh::previous(h)]);
    if (sign > 0)
      ++facts.positive;
    else if (sign < 0)
      ++facts.negative;
    else
      ++facts.zero;
    if (sign <= 0) facts.notPositive.push_back(f);
    for (VertexId v : mesh.corners(f)) {
      if (!isCone[v] && !mesh.isBoundary(v)) continue;
      ++facts.constrained;
      facts.constrainedPositive += sign > 0;
      break;
    }
  }
  return facts;
}

}  // namespace hgp
