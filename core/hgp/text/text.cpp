#include "hgp/text/text.h"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "hgp/base/check.h"

namespace hgp::text {

namespace {

/// Parses the number at s, finite or not, and returns its end; nullptr if there is none. fast_float reads "1e" as 1.
const char* parse(const char* s, const char* end, double& value) {
  const auto answer = fast_float::from_chars(s, end, value);
  const bool isCut = answer.ptr != end && (*answer.ptr == 'e' || *answer.ptr == 'E');
  return answer.ec == std::errc::invalid_argument || isCut ? nullptr : answer.ptr;
}

}  // namespace

bool readDouble(const char*& p, const char* end, double& out) {
  // fast_float does not accept a plus sign, but accepts "nan" and "inf".
  const char* s = p != end && *p == '+' ? p + 1 : p;
  const char* digits = p != end && *p == '-' ? p + 1 : s;
  if (digits == end || !(isDigit(*digits) || *digits == '.')) return false;
  double value = 0.0;
  const char* ptr = parse(s, end, value);
  if (ptr == nullptr || !std::isfinite(value)) return false;
  out = value;
  p = ptr;
  return true;
}

bool readAnyDouble(const char*& p, const char* end, double& out) {
  const char* begin = p;
  const char* ptr = parse(p != end && *p == '+' ? p + 1 : p, end, out);
  if (ptr == nullptr) return false;
  if (ptr != end && *ptr == '#' && isInNumber(begin, ptr, end)) {
    while (ptr != end && !isBlank(*ptr) && *ptr != '\n') ++ptr;
    out = std::numeric_limits<double>::quiet_NaN();
  }
  p = ptr;
  return true;
}

void appendDouble(std::string& out, double value) {
  if (!std::isfinite(value)) {
    out += std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
    return;
  }
  // Not std::to_chars, which Emscripten's library lacks for doubles.
  const std::string text = nlohmann::json(value).dump();
  const bool isWhole = text.ends_with(".0");
  out.append(text, 0, text.size() - (isWhole ? 2 : 0));
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
  while (p_ != end_ && !isBlank(*p_) && *p_ != '\n' && (*p_ != '#' || isInNumber(begin, p_, end_)))
    ++p_;
  return word_ = std::string_view(begin, static_cast<std::size_t>(p_ - begin));
}

bool WordReader::nextDouble(double& out) {
  next();
  const char* p = word_.data();
  const char* end = p + word_.size();
  return !word_.empty() && readDouble(p, end, out) && p == end;
}

bool WordReader::nextAnyDouble(double& out) {
  next();
  const char* p = word_.data();
  const char* end = p + word_.size();
  return !word_.empty() && readAnyDouble(p, end, out) && p == end;
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

std::string_view beginningOf(std::string_view text, std::size_t limit) {
  if (text.size() <= limit) return text;
  // Bytes 10xxxxxx continue a character, of which there are at most three.
  std::size_t end = limit;
  while (end > 0 && limit - end < 3 && (static_cast<unsigned char>(text[end]) & 0xc0U) == 0x80U)
    --end;
  return text.substr(0, end);
}

bool isNestedDeeper(std::string_view json, int depth) {
  int open = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (isInString) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        isInString = false;
    } else if (c == '"') {
      isInString = true;
    } else if (c == '[' || c == '{') {
      if (++open > depth) return true;
    } else if (c == ']' || c == '}') {
      --open;
    }
  }
  return false;
}

std::string inQuotes(std::string_view text, std::size_t limit) {
  std::string out = "'";
  for (char c : beginningOf(text, limit)) {
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

}  // namespace hgp::text
