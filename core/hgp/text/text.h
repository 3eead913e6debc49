// Numbers as text, the same under every locale and on every platform.  Role: what the text formats
// share; readers are as fast as memory and exact to the last bit.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hgp/base/result.h"

namespace hgp::io {

/// Blank inside a line.
constexpr bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

inline void skipBlanks(const char*& p, const char* end) {
  while (p != end && isBlank(*p)) ++p;
}

/// Reads the double nearest to the decimal text at p and moves p behind it. False (p unmoved) when
/// there is no number or it is not finite; "nan" and "inf" are no numbers here.
bool readDouble(const char*& p, const char* end, double& out);

/// … or what is not finite, as programs write it: nan, -inf, infinity, 1.#QNAN, 1e999.
bool readAnyDouble(const char*& p, const char* end, double& out);

/// Whether the '#' at p belongs to a number that is not finite, as older Windows programs write it
/// ("-1.#IND"), and begins no comment. @param begin  of the word
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

/// Decimal text that reads back as exactly this finite double: 17 digits at most, nearly always the
/// fewest possible.
void appendDouble(std::string& out, double value);
void appendInt(std::string& out, std::int64_t value);

/// The byte that ends a line: '\n', or '\r' in a text that has no '\n' at all (old Macintosh files).
char lineEndOf(std::string_view text);

/// Walks over the words of a text, blanks and line ends alike, with '#' comments skipped.
class WordReader {
 public:
  explicit WordReader(std::string_view text)
      : p_(text.data()), end_(text.data() + text.size()), lineEnd_(lineEndOf(text)) {}
  /// The next word, or an empty view at the end.
  std::string_view next();
  /// The next word as a number; false when it is not one, and `word` then holds it.
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

/// The line that starts in `text` at or before `offset`, counted from 1.
std::int64_t lineAt(std::string_view text, std::size_t offset);

/// At most `limit` bytes of text from a file for a message, control bytes replaced.
std::string inQuotes(std::string_view text, std::size_t limit = 40);

/// A kMalformed failure of the reading stage that names a line.
Failure malformedLine(std::int64_t line, const std::string& message);
/// … and one that names a byte.
Failure malformedByte(std::uint64_t offset, const std::string& message);

}  // namespace hgp::io
