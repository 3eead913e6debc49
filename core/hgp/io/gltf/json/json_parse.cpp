#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/json.h"

namespace hgp::io {
namespace {

bool isJsonDigit(char c) { return c >= '0' && c <= '9'; }

/// Length of the UTF-8 sequence that starts at p, 0 when it is not well formed.
std::size_t sequenceLength(const unsigned char* p, const unsigned char* end) {
  const unsigned char lead = *p;
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || static_cast<std::size_t>(end - p) < length) return 0;
  for (std::size_t k = 1; k < length; ++k) {
    if ((p[k] & 0xC0) != 0x80) return 0;
  }
  const bool isOverlong = (lead == 0xE0 && p[1] < 0xA0) || (lead == 0xF0 && p[1] < 0x90);
  const bool isSurrogate = lead == 0xED && p[1] >= 0xA0;
  const bool isTooLarge = lead == 0xF4 && p[1] >= 0x90;
  return isOverlong || isSurrogate || isTooLarge ? 0 : length;
}

}  // namespace

/// A recursive-descent parser; the limit on nesting bounds the stack.
class JsonParser {
 public:
  JsonParser(JsonText& out, const JsonLimits& limits)
      : out_(out),
        limits_(limits),
        begin_(out.text_.data()),
        p_(begin_),
        end_(begin_ + out.text_.size()) {}

  Status run() {
    if (!checkUtf8()) return failure_;
    if (out_.text_.compare(0, 3, "\xEF\xBB\xBF") == 0) p_ += 3;
    skipSpace();
    if (p_ == end_) fail("the JSON text is empty");
    if (!hasFailed_) value(-1, 0, 0, 0);
    skipSpace();
    if (!hasFailed_ && p_ != end_) fail("more text after the JSON value");
    if (hasFailed_) return failure_;
    return Done{};
  }

 private:
  void fail(const std::string& message) { failAt(p_, ErrorCode::kMalformed, message); }

  void failAt(const char* place, ErrorCode code, const std::string& message) {
    if (hasFailed_) return;
    hasFailed_ = true;
    const long long offset = place - begin_;
    failure_ = {code,
                "read",
                formatText("JSON, byte %lld: %s", offset, message.c_str()),
                {{Where::Kind::kByte, offset}}};
  }

  bool checkUtf8() {
    const auto* end = reinterpret_cast<const unsigned char*>(end_);
    for (const auto* p = reinterpret_cast<const unsigned char*>(begin_); p != end;) {
      const std::size_t length = sequenceLength(p, end);
      if (length == 0) {
        failAt(reinterpret_cast<const char*>(p), ErrorCode::kMalformed, "not valid UTF-8");
        return false;
      }
      p += length;
    }
    return true;
  }

  void skipSpace() {
    while (p_ != end_ && (*p_ == ' ' || *p_ == '\n' || *p_ == '\r' || *p_ == '\t')) ++p_;
  }

  std::uint32_t offset() const { return static_cast<std::uint32_t>(p_ - begin_); }

  /// Parses the value at p_ as a child of `parent`; returns its node.
  int value(int parent, std::uint32_t keyBegin, std::uint32_t keyEnd, int depth) {
    if (out_.nodes_.size() >= limits_.values) {
      failAt(p_, ErrorCode::kLimit, formatText("more than %zu values", limits_.values));
      return -1;
    }
    const int index = static_cast<int>(out_.nodes_.size());
    JsonNode fresh;
    fresh.begin = offset();
    fresh.keyBegin = keyBegin;
    fresh.keyEnd = keyEnd;
    fresh.parent = parent;
    out_.nodes_.push_back(fresh);
    const char c = p_ == end_ ? '\0' : *p_;
    JsonKind kind = JsonKind::kNull;
    if (c == '{' || c == '[') {
      kind = c == '{' ? JsonKind::kObject : JsonKind::kArray;
      container(index, kind, depth + 1);
    } else if (c == '"') {
      kind = JsonKind::kString;
      stringLiteral();
    } else if (c == '-' || isJsonDigit(c)) {
      kind = JsonKind::kNumber;
      numberLiteral();
    } else {
      kind = word();
    }
    JsonNode& done = out_.nodes_[static_cast<std::size_t>(index)];
    done.kind = kind;
    done.end = offset();
    return index;
  }

  void container(int index, JsonKind kind, int depth) {
    if (depth > limits_.depth) {
      fail(formatText("nested deeper than %d levels", limits_.depth));
      return;
    }
    const char close = kind == JsonKind::kObject ? '}' : ']';
    ++p_;
    skipSpace();
    int count = 0, last = -1;
    bool isMore = p_ == end_ || *p_ != close;
    while (isMore && !hasFailed_) {
      std::uint32_t keyBegin = 0, keyEnd = 0;
      if (kind == JsonKind::kObject) {
        keyBegin = offset();
        memberKey();
        keyEnd = keyBegin + keyLength_;
        if (hasFailed_) return;
      }
      const int child = value(index, keyBegin, keyEnd, depth);
      if (hasFailed_) return;
      if (last >= 0) out_.nodes_[static_cast<std::size_t>(last)].next = child;
      last = child;
      ++count;
      skipSpace();
      isMore = p_ != end_ && *p_ == ',';
      if (isMore) {
        ++p_;
        skipSpace();
      }
    }
    if (hasFailed_) return;
    if (p_ == end_ || *p_ != close) {
      fail(formatText("expected ',' or '%c'", close));
      return;
    }
    ++p_;
    out_.nodes_[static_cast<std::size_t>(index)].count = count;
    if (kind == JsonKind::kObject) checkKeys(index, count);
  }

  void memberKey() {
    const char* start = p_;
    if (p_ == end_ || *p_ != '"') {
      fail("expected a key in quotes");
      return;
    }
    stringLiteral();
    keyLength_ = static_cast<std::uint32_t>(p_ - start);
    skipSpace();
    if (hasFailed_ || p_ == end_ || *p_ != ':') {
      fail("expected ':'");
      return;
    }
    ++p_;
    skipSpace();
  }

  void checkKeys(int index, int count) {
    if (count < 2) return;
    std::vector<std::pair<std::string, int>> keys;
    keys.reserve(static_cast<std::size_t>(count));
    for (int c = index + 1; c >= 0; c = out_.node(c).next) keys.emplace_back(out_.key(c), c);
    std::sort(keys.begin(), keys.end());
    for (std::size_t k = 1; k < keys.size(); ++k) {
      if (keys[k].first != keys[k - 1].first) continue;
      failAt(begin_ + out_.node(keys[k].second).keyBegin, ErrorCode::kMalformed,
             "the same key twice in one object");
      return;
    }
  }

  void stringLiteral() {
    ++p_;
    while (p_ != end_ && *p_ != '"') {
      if (static_cast<unsigned char>(*p_) < 0x20) {
        fail("control character in a string");
        return;
      }
      if (*p_ == '\\' && !escape()) return;
      ++p_;
    }
    if (p_ == end_) {
      fail("string without a closing quote");
      return;
    }
    ++p_;
  }

  /// Checks an escape sequence and leaves p_ on its last character.
  bool escape() {
    ++p_;
    if (p_ != end_ && std::string_view("\"\\/bfnrt").find(*p_) != std::string_view::npos)
      return true;
    if (p_ != end_ && *p_ == 'u' && end_ - p_ > 4) {
      bool isHex = true;
      for (int k = 1; k <= 4; ++k) {
        const char c = p_[k];
        isHex = isHex && (isJsonDigit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'));
      }
      if (isHex) {
        p_ += 4;
        return true;
      }
    }
    fail("unknown escape in a string");
    return false;
  }

  bool digits() {
    const char* start = p_;
    while (p_ != end_ && isJsonDigit(*p_)) ++p_;
    return p_ != start;
  }

  void numberLiteral() {
    const char* start = p_;
    if (*p_ == '-') ++p_;
    const char* first = p_;
    bool isGood = digits() && !(*first == '0' && p_ - first > 1);
    if (isGood && p_ != end_ && *p_ == '.') {
      ++p_;
      isGood = digits();
    }
    if (isGood && p_ != end_ && (*p_ == 'e' || *p_ == 'E')) {
      ++p_;
      if (p_ != end_ && (*p_ == '+' || *p_ == '-')) ++p_;
      isGood = digits();
    }
    if (!isGood) failAt(start, ErrorCode::kMalformed, "not a JSON number");
  }

  JsonKind word() {
    const std::string_view rest(p_, static_cast<std::size_t>(end_ - p_));
    for (const auto& [name, kind] : {std::pair{std::string_view("null"), JsonKind::kNull},
                                     std::pair{std::string_view("true"), JsonKind::kTrue},
                                     std::pair{std::string_view("false"), JsonKind::kFalse}}) {
      if (rest.substr(0, name.size()) != name) continue;
      p_ += name.size();
      return kind;
    }
    fail("expected a value");
    return JsonKind::kNull;
  }

  JsonText& out_;
  const JsonLimits& limits_;
  const char* begin_;
  const char* p_;
  const char* end_;
  std::uint32_t keyLength_ = 0;
  bool hasFailed_ = false;
  Failure failure_;
};

Result<JsonText> JsonText::parse(std::string text, const JsonLimits& limits) {
  if (text.size() > limits.bytes) {
    return Failure{
        ErrorCode::kLimit,
        "read",
        formatText("the JSON text has %zu bytes, the limit is %zu", text.size(), limits.bytes),
        {}};
  }
  JsonText out;
  out.text_ = std::move(text);
  const Status status = JsonParser(out, limits).run();
  if (!status) return status.error();
  return out;
}

}  // namespace hgp::io
