// JSON text with the place of every value in it.  Role: what glTF validation reads and the lossless
// patch splices; the text itself is never rewritten.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/base/result.h"

namespace hgp::io {

enum class JsonKind : std::uint8_t { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };

/// One value, in the order of the text; a container's first child is the node behind it.
struct JsonNode {
  std::uint32_t begin = 0;  ///< of the value in the text
  std::uint32_t end = 0;
  std::uint32_t keyBegin = 0;  ///< of the member's key with its quotes; keyBegin = keyEnd: no key
  std::uint32_t keyEnd = 0;
  std::int32_t parent = -1;
  std::int32_t next = -1;  ///< next sibling, −1 at the last
  std::int32_t count = 0;  ///< children
  JsonKind kind = JsonKind::kNull;
};

/// Guards against hostile texts; generous for any real file.
struct JsonLimits {
  int depth = 64;
  std::size_t bytes = std::size_t{64} << 20;
  std::size_t values = 8'000'000;
};

/// A parsed text. Nodes are named by index; −1 is "not there" and is accepted by every query.
class JsonText {
 public:
  static constexpr int kRoot = 0;

  /// Strict RFC 8259 with a leading byte order mark allowed; duplicate keys, invalid UTF-8, nesting
  /// beyond the limit are kMalformed with a byte offset, size beyond the limits is kLimit.
  static Result<JsonText> parse(std::string text, const JsonLimits& limits = {});

  const std::string& text() const { return text_; }
  int size() const { return static_cast<int>(nodes_.size()); }
  const JsonNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  bool isKind(int i, JsonKind kind) const { return i >= 0 && node(i).kind == kind; }
  bool isObject(int i) const { return isKind(i, JsonKind::kObject); }
  bool isArray(int i) const { return isKind(i, JsonKind::kArray); }
  bool isString(int i) const { return isKind(i, JsonKind::kString); }
  int firstChild(int i) const { return i >= 0 && node(i).count > 0 ? i + 1 : -1; }

  /// Member of an object, −1 when there is none (or `object` is none).
  int find(int object, std::string_view key) const;
  /// Children of an array or object in order; empty for anything else.
  std::vector<int> children(int i) const;
  /// The bytes of the value as they stand in the text.
  std::string_view raw(int i) const;
  std::string key(int i) const;
  /// Decoded string; "" for anything else.
  std::string string(int i) const;
  bool isTrue(int i) const { return isKind(i, JsonKind::kTrue); }
  /// A number written as a plain integer that fits 53 bits (no fraction, no exponent).
  std::optional<std::int64_t> integer(int i) const;
  /// Any finite number.
  std::optional<double> number(int i) const;
  /// RFC 6901 pointer of a value, for messages: "/meshes/0/primitives/1".
  std::string pointer(int i) const;

 private:
  friend class JsonParser;
  std::string text_;
  std::vector<JsonNode> nodes_;
};

/// The text between two quotes with escapes undone.
std::string unescapeJson(std::string_view inner);
/// A JSON string literal, quotes included.
std::string quoteJson(std::string_view value);

}  // namespace hgp::io
