#include "hgp/text/text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

namespace hgp::io {
namespace {

bool readsAs(const std::string& text, double expected) {
  const char* p = text.data();
  double value = -12345;
  return text::readDouble(p, text.data() + text.size(), value) && p == text.data() + text.size() &&
         std::memcmp(&value, &expected, sizeof value) == 0;
}

TEST(ReadDouble, IsTheNearestDoubleForEveryPrintedOne) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t bits = random();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x)) continue;
    std::string text;
    text::appendDouble(text, x);
    ASSERT_TRUE(readsAs(text, x)) << text;
    char buffer[64];
    int exponent = 0;
    std::snprintf(buffer, sizeof buffer, "%.17g", x);
    ASSERT_TRUE(readsAs(buffer, x)) << buffer;
    // Ordinary sizes at every number of digits: integers do these.
    const double ordinary = std::ldexp(std::frexp(x, &exponent), exponent % 60);
    std::snprintf(buffer, sizeof buffer, "%.*g", 15 + i % 5, ordinary);
    ASSERT_TRUE(readsAs(buffer, std::strtod(buffer, nullptr))) << buffer;
    std::snprintf(buffer, sizeof buffer, "%.6f", std::fmod(x, 1000.0));
    ASSERT_TRUE(readsAs(buffer, std::strtod(buffer, nullptr))) << buffer;
  }
}

TEST(ReadDouble, RoundsOnceWhateverWasCutOff) {
  // One in two thousand of these lies a little above the middle between two doubles.
  std::mt19937_64 random(8);
  for (int i = 0; i < 200000; ++i) {
    char buffer[64];
    const auto mantissa = static_cast<unsigned long long>(random() >> 1) | (1ULL << 62);
    std::snprintf(buffer, sizeof buffer, "%llue-%d", mantissa, 1 + i % 27);
    ASSERT_TRUE(readsAs(buffer, std::strtod(buffer, nullptr))) << buffer;
  }
}

TEST(ReadDouble, AcceptsEverySpelling) {
  EXPECT_TRUE(readsAs("1", 1));
  EXPECT_TRUE(readsAs("+1.5", 1.5));
  EXPECT_TRUE(readsAs(".5", 0.5));
  EXPECT_TRUE(readsAs("5.", 5));
  EXPECT_TRUE(readsAs("-0", -0.0));
  EXPECT_TRUE(readsAs("1e3", 1000));
  EXPECT_TRUE(readsAs("1E-3", 0.001));
  EXPECT_TRUE(readsAs("9007199254740993", 9007199254740992.0));
  EXPECT_TRUE(readsAs("9007199254740995", 9007199254740996.0));
  EXPECT_TRUE(readsAs("9007199254740993e-1", 900719925474099.3));
  EXPECT_TRUE(readsAs("1.2345678901234567e-10", 1.2345678901234567e-10));
  EXPECT_TRUE(readsAs("9999999999999999999e27", 9999999999999999999e27));
  EXPECT_TRUE(readsAs("9999999999999999999e-27", 9999999999999999999e-27));
  EXPECT_TRUE(readsAs("123456789012345678901234567890", 123456789012345678901234567890.0));
  EXPECT_TRUE(readsAs("0.1000000000000000055511151231257827021181583404541015625", 0.1));
  EXPECT_TRUE(readsAs("4.9406564584124654e-324", std::numeric_limits<double>::denorm_min()));
  EXPECT_TRUE(readsAs("1e-400", 0.0));
  EXPECT_TRUE(readsAs("2.2250738585072011e-308", 2.2250738585072011e-308));
}

TEST(ReadDouble, RefusesWhatIsNoFiniteNumber) {
  for (const std::string text :
       {"", "-", ".", "e5", "nan", "inf", "-inf", "1e999", "1e", "x1", "1e+"}) {
    const char* p = text.data();
    double value = 0;
    EXPECT_FALSE(text::readDouble(p, text.data() + text.size(), value)) << text;
    EXPECT_EQ(p, text.data());
  }
}

TEST(ReadDouble, StopsAtACommaWhateverTheLocale) {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  const std::string text = "1,5";
  const char* p = text.data();
  double value = 0;
  EXPECT_TRUE(text::readDouble(p, text.data() + text.size(), value));
  EXPECT_EQ(value, 1);
  EXPECT_EQ(p - text.data(), 1);
  std::string printed;
  text::appendDouble(printed, 0.5);
  EXPECT_EQ(printed, "0.5");
  std::setlocale(LC_ALL, "C");
}

TEST(ReadInt, RefusesOverflow) {
  const std::string text = "9999999999999999999";
  const char* p = text.data();
  std::int64_t value = 0;
  EXPECT_FALSE(text::readInt(p, text.data() + text.size(), value));
}

TEST(Quoted, HidesControlBytesAndLength) {
  EXPECT_EQ(text::inQuotes("a\x1b[31m"), "'a?[31m'");
  EXPECT_EQ(text::inQuotes(std::string(100, 'x'), 3), "'xxx…'");
}

TEST(Quoted, CutsNoCharacterInTwo) {
  const std::string o = "ö", euro = "€", clef = "\xf0\x9d\x84\x9e";
  for (const std::string& letter : {o, euro, clef}) {
    const std::string word = letter + letter + letter;
    for (std::size_t limit = 0; limit <= word.size(); ++limit) {
      const std::size_t whole = limit / letter.size() * letter.size();
      EXPECT_EQ(text::beginningOf(word, limit), word.substr(0, whole)) << limit;
    }
  }
  EXPECT_EQ(text::inQuotes(o + o, 3), "'ö…'");
  // Bytes that are no UTF-8 are cut anywhere.
  EXPECT_EQ(text::beginningOf(std::string(9, '\x80'), 6).size(), 3U);
}

TEST(Nesting, IsCountedOutsideOfStrings) {
  EXPECT_FALSE(text::isNestedDeeper("{\"a\": [1, {}]}", 3));
  EXPECT_TRUE(text::isNestedDeeper("{\"a\": [1, {}]}", 2));
  EXPECT_FALSE(text::isNestedDeeper("[[],[],[[]]]", 3));
  EXPECT_FALSE(text::isNestedDeeper("[\"[[[\\\"[[[\"]", 1));
}

}  // namespace
}  // namespace hgp::io
