#include "hgp/text/text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/detail/conversions/to_chars.hpp>

#include "hgp/base/check.h"

namespace hgp::io {
namespace {

constexpr double kPowerOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                  1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                  1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// A decimal number taken apart: ±mantissa · 10^exponent over [begin, end).
struct Decimal {
  std::uint64_t mantissa = 0;
  int exponent = 0;
  bool isNegative = false;
  bool isExact = true;  ///< no digit was dropped
};

/// Takes digits into d; true when there was one.
bool takeDigits(const char*& s, const char* end, Decimal& d, bool isFraction) {
  const char* first = s;
  for (; s != end && isDigit(*s); ++s) {
    if (d.mantissa < 1'000'000'000'000'000'000u) {
      d.mantissa = d.mantissa * 10 + static_cast<std::uint64_t>(*s - '0');
      if (isFraction) --d.exponent;
    } else {
      d.isExact = d.isExact && *s == '0';
      if (!isFraction) ++d.exponent;
    }
  }
  return s != first;
}

bool takeExponent(const char*& s, const char* end, Decimal& d) {
  if (s == end || (*s != 'e' && *s != 'E')) return true;
  const char* e = s + 1;
  const bool isNegative = e != end && *e == '-';
  if (e != end && (*e == '-' || *e == '+')) ++e;
  if (e == end || !isDigit(*e)) return false;
  int exponent = 0;
  for (; e != end && isDigit(*e); ++e) exponent = std::min(exponent * 10 + (*e - '0'), 100000);
  d.exponent += isNegative ? -exponent : exponent;
  s = e;
  return true;
}

bool takeDecimal(const char*& s, const char* end, Decimal& d) {
  if (s != end && (*s == '-' || *s == '+')) d.isNegative = *s++ == '-';
  bool hasDigits = takeDigits(s, end, d, false);
  if (s != end && *s == '.') hasDigits = takeDigits(++s, end, d, true) || hasDigits;
  return hasDigits && takeExponent(s, end, d);
}

using Wide = unsigned __int128;

/// 5^0 … 5^27, all below 2^63.
constexpr auto kPowerOfFive = [] {
  std::array<std::uint64_t, 28> powers{1};
  for (std::size_t k = 1; k < powers.size(); ++k) powers[k] = 5 * powers[k - 1];
  return powers;
}();
constexpr int kLargestPower = static_cast<int>(kPowerOfFive.size()) - 1;

/// value · 2^exponent rounded once, ties to even. `hasMore`: something below was cut off.
double roundOnce(Wide value, int exponent, bool hasMore) {
  const auto high = static_cast<std::uint64_t>(value >> 64),
             low = static_cast<std::uint64_t>(value);
  const int bits = high != 0 ? 128 - std::countl_zero(high) : 64 - std::countl_zero(low);
  const int drop = std::max(bits - std::numeric_limits<double>::digits, 0);
  auto kept = static_cast<std::uint64_t>(value >> drop);
  if (drop > 0) {
    const Wide half = Wide{1} << (drop - 1), rest = value & (2 * half - 1);
    if (rest > half || (rest == half && (hasMore || kept % 2 == 1))) ++kept;
  }
  return std::ldexp(static_cast<double>(kept), exponent + drop);
}

/// Nineteen digits and a moderate power of ten, by integers. (The C libraries' own way is exact too,
/// and twenty times slower in WebAssembly.)
double readWide(const Decimal& d) {
  const std::uint64_t m = d.mantissa;
  if (d.exponent >= 0)
    return roundOnce(Wide{m} * kPowerOfFive[static_cast<std::size_t>(d.exponent)], d.exponent,
                     false);
  const int shift = std::countl_zero(m) + 63;
  const Wide numerator = Wide{m} << shift;
  const std::uint64_t divisor = kPowerOfFive[static_cast<std::size_t>(-d.exponent)];
  const Wide quotient = numerator / divisor;  // 64 bits at least
  return roundOnce(quotient, d.exponent - shift, quotient * divisor != numerator);
}

/// Correct rounding by the library, for everything else.
bool readSlowly(const char* begin, const char* end, const Decimal& d, double& out) {
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
  if (begin != end && *begin == '+') ++begin;
  const auto answer = std::from_chars(begin, end, out);
  if (answer.ec == std::errc::result_out_of_range) {
    if (d.mantissa != 0 && d.exponent > 0) return false;
    out = d.isNegative ? -0.0 : 0.0;
  }
#else
  // musl's strtod rounds correctly and knows no locale but "C"; it wants a terminated text.
  const std::string copy(begin, end);
  out = std::strtod(copy.c_str(), nullptr);
  (void)d;
#endif
  return std::isfinite(out);
}

}  // namespace

bool readDouble(const char*& p, const char* end, double& out) {
  const char* s = p;
  Decimal d;
  if (!takeDecimal(s, end, d)) return false;
  // Both the mantissa and the power are exact doubles, so one rounding gives the nearest double.
  if (d.isExact && d.mantissa <= (std::uint64_t{1} << 53) && d.exponent >= -22 &&
      d.exponent <= 22) {
    const double m = static_cast<double>(d.mantissa);
    const double value =
        d.exponent < 0 ? m / kPowerOfTen[-d.exponent] : m * kPowerOfTen[d.exponent];
    out = d.isNegative ? -value : value;
  } else if (d.isExact && d.mantissa != 0 && std::abs(d.exponent) <= kLargestPower) {
    out = d.isNegative ? -readWide(d) : readWide(d);
  } else if (!readSlowly(p, s, d, out)) {
    return false;
  }
  p = s;
  return true;
}

void appendDouble(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    return;
  }
  // Not std::to_chars, which Emscripten's library lacks for doubles.
  char buffer[64];
  const char* end = nlohmann::detail::to_chars(buffer, buffer + sizeof buffer, value);
  if (end - buffer > 2 && end[-1] == '0' && end[-2] == '.') end -= 2;
  out.append(buffer, static_cast<std::size_t>(end - buffer));
}

void appendInt(std::string& out, std::int64_t value) {
  char buffer[24];
  const auto answer = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, answer.ptr);
}

char lineEndOf(std::string_view text) {
  const bool isOld = text.find('\n') == std::string_view::npos;
  return isOld && text.find('\r') != std::string_view::npos ? '\r' : '\n';
}

void WordReader::skip() {
  for (; p_ != end_; ++p_) {
    if (*p_ == lineEnd_) {
      ++line_;
    } else if (*p_ == '#') {
      while (p_ != end_ && *p_ != lineEnd_) ++p_;
      if (p_ == end_) return;
      ++line_;
    } else if (!isBlank(*p_)) {
      return;
    }
  }
}

bool WordReader::isAtEnd() {
  skip();
  return p_ == end_;
}

std::string_view WordReader::next() {
  skip();
  const char* begin = p_;
  while (p_ != end_ && !isBlank(*p_) && *p_ != '\n' && *p_ != '#') ++p_;
  return word_ = std::string_view(begin, static_cast<std::size_t>(p_ - begin));
}

bool WordReader::nextDouble(double& out) {
  next();
  const char* p = word_.data();
  const char* end = p + word_.size();
  return !word_.empty() && readDouble(p, end, out) && p == end;
}

bool WordReader::nextInt(std::int64_t& out) {
  next();
  const char* p = word_.data();
  const char* end = p + word_.size();
  return !word_.empty() && readInt(p, end, out) && p == end;
}

std::string_view WordReader::restOfLine() {
  const char* begin = p_;
  while (p_ != end_ && *p_ != lineEnd_) ++p_;
  return std::string_view(begin, static_cast<std::size_t>(p_ - begin));
}

std::int64_t lineAt(std::string_view text, std::size_t offset) {
  const auto stop = text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size()));
  return 1 + std::count(text.begin(), stop, lineEndOf(text));
}

std::string inQuotes(std::string_view text, std::size_t limit) {
  std::string out = "'";
  for (char c : text.substr(0, limit)) {
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  return out + (text.size() > limit ? "…'" : "'");
}

Failure malformedLine(std::int64_t line, const std::string& message) {
  return {ErrorCode::kMalformed,
          "read",
          formatText("line %lld: ", static_cast<long long>(line)) + message,
          {{Where::Kind::kLine, line}}};
}

Failure malformedByte(std::uint64_t offset, const std::string& message) {
  return {ErrorCode::kMalformed,
          "read",
          formatText("byte %llu: ", static_cast<unsigned long long>(offset)) + message,
          {{Where::Kind::kByte, static_cast<std::int64_t>(offset)}}};
}

}  // namespace hgp::io
