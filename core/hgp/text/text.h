// Numbers as text, the same in every locale and on every platform.  Role: shared by the text formats;
// reading is fast and exact to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hgp/base/result.h"

namespace hgp::text {

/// Whether c is a blank inside a line.
constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

inline void skipBlanks(const char*& p, const char* end) {
  while (p != end && isBlank(*p)) ++p;
}

/// Reads the double nearest to the decimal text at p and moves p after it. False, with p unchanged, if
/// there is no number or it is not finite; "nan" and "inf" are not accepted.
bool readDouble(const char*& p, const char* end, double& out);

/// The same, also accepting numbers that are not finite as programs write them: nan, -inf, infinity, 1.#QNAN, 1e999.
bool readAnyDouble(const char*& p, const char* end, double& out);

/// Whether the '#' at p belongs to a number that is not finite, as written by older Windows programs ("-1.#IND"),
/// instead of starting a comment. @param begin  beginning of the word
inline bool isInNumber(const char* begin, const char* p, const char* end) {
  return p != begin && p[-1] == '.' && end - p > 1 && (p[1] == 'I' || p[1] == 'Q' || p[1] == 'S');
}

/// Reads an integer with optional sign; false when there is none or it exceeds 18 digits.
inline bool readInt(const char*& p, const char* end, std::int64_t& out) {
  const char* s = p;
  const bool isNegative = s != end && *s == '-';
  if (s != end && (*s == '-' || *s == '+')) ++s;
  const char* digits = s;
  std::int64_t value = 0;
  while (s != end && isDigit(*s) && s - digits < 18) value = value * 10 + (*s++ - '0');
  if (s == digits || (s != end && isDigit(*s))) return false;
  out = isNegative ? -value : value;
  p = s;
  return true;
}

/// Appends decimal text that reads back as exactly this finite double: at most 17 digits, nearly always the
/// fewest possible.
void appendDouble(std::string& out, double value);
void appendInt(std::string& out, std::int64_t value);

/// The byte that ends a line: '\n', or '\r' in a text without any '\n' (old Macintosh files).
char lineEndOf(std::string_view text);

/// Iterates over the words of a text, separated by blanks or line ends; '#' comments are skipped.
class WordReader {
 public:
  explicit WordReader(std::string_view text)
      : p_(text.data()), end_(text.data() + text.size()), lineEnd_(lineEndOf(text)) {}
  /// The next word, or an empty view at the end.
  std::string_view next();
  /// Reads the next word as a number; false if it is not one, and `word` then returns it.
  bool nextDouble(double& out);
  bool nextAnyDouble(double& out);
  bool nextInt(std::int64_t& out);
  /// The rest of the current line without its end.
  std::string_view restOfLine();
  std::string_view word() const { return word_; }
  int line() const { return line_; }
  bool isAtEnd();

 private:
  void skip();
  const char* p_;
  const char* end_;
  char lineEnd_;
  int line_ = 1;
  std::string_view word_;
};

/// The number of the line of `text` that contains `offset`, counted from 1.
std::int64_t lineAt(std::string_view text, std::size_t offset);

/// The first characters of UTF-8 that fit in `limit` bytes; a character is not cut in two.
std::string_view beginningOf(std::string_view text, std::size_t limit);

/// Whether arrays and objects of this JSON are nested more than `depth` deep. Checked before parsing, since what parses and
/// writes such a document needs stack.
bool isNestedDeeper(std::string_view json, int depth);

/// Text from a file, quoted for a message: at most `limit` bytes, with control bytes replaced.
std::string inQuotes(std::string_view text, std::size_t limit = 40);

/// A kMalformed failure of the reading stage that names a line.
Failure malformedLine(std::int64_t line, const std::string& message);
/// A kMalformed failure of the reading stage that names a byte.
Failure malformedByte(std::uint64_t offset, const std::string& message);

}  // namespace hgp::text
