// JSON text with the position of every value in it.  Role: glTF validation reads it and the lossless
// patch edits it at those positions; the text itself is never serialised anew.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/base/result.h"

namespace hgp::io {

enum class JsonKind : std::uint8_t { kNull, kFalse, kTrue, kNumber, kString, kArray, kObject };

/// One value. Nodes are in the order of the text, so a container's first child is the node after it.
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

/// Limits that protect against hostile texts; real files stay far below them.
struct JsonLimits {
  int depth = 64;
  std::size_t bytes = std::size_t{64} << 20;
  std::size_t values = 8'000'000;
};

/// A parsed text. Nodes are identified by index; −1 means "no such node" and is accepted by every query.
class JsonText {
 public:
  static constexpr int kRoot = 0;

  /// Parses strict RFC 8259, with an optional byte order mark. Fails with kMalformed and a byte offset for
  /// invalid text, duplicate keys, invalid UTF-8 and nesting beyond the limit, with kLimit beyond the other limits.
  static Result<JsonText> parse(std::string text, const JsonLimits& limits = {});

  const std::string& text() const { return text_; }
  int size() const { return static_cast<int>(nodes_.size()); }
  const JsonNode& node(int i) const { return nodes_[static_cast<std::size_t>(i)]; }
  bool isKind(int i, JsonKind kind) const { return i >= 0 && node(i).kind == kind; }
  bool isObject(int i) const { return isKind(i, JsonKind::kObject); }
  bool isArray(int i) const { return isKind(i, JsonKind::kArray); }
  bool isString(int i) const { return isKind(i, JsonKind::kString); }
  int firstChild(int i) const { return i >= 0 && node(i).count > 0 ? i + 1 : -1; }

  /// Member of an object; −1 if it has none of this name, or if `object` is not an object.
  int find(int object, std::string_view key) const;
  /// Children of an array or object in order; empty for anything else.
  std::vector<int> children(int i) const;
  /// The text of the value, byte for byte.
  std::string_view raw(int i) const;
  std::string key(int i) const;
  /// Decoded string; "" for anything else.
  std::string string(int i) const;
  bool isTrue(int i) const { return isKind(i, JsonKind::kTrue); }
  /// A number written as an integer, without fraction or exponent, that fits into 53 bits.
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

/// The text between two quotes with its escape sequences decoded.
std::string unescapeJson(std::string_view inner);
/// A JSON string literal, quotes included.
std::string quoteJson(std::string_view value);

}  // namespace hgp::io
