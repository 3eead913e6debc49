#include "hgp/io/gltf/json/json.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

void appendUtf8(std::string& out, std::uint32_t code) {
  const auto byte = [&](std::uint32_t b) { out.push_back(static_cast<char>(b)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | (code >> 6));
    byte(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    byte(0xE0 | (code >> 12));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  } else {
    byte(0xF0 | (code >> 18));
    byte(0x80 | ((code >> 12) & 0x3F));
    byte(0x80 | ((code >> 6) & 0x3F));
    byte(0x80 | (code & 0x3F));
  }
}

/// The value of four hexadecimal digits. @pre there are four
std::uint32_t hexCode(std::string_view digits) {
  std::uint32_t code = 0;
  for (char c : digits) {
    const int value = text::isDigit(c) ? c - '0' : (c | 0x20) - 'a' + 10;
    code = code * 16 + static_cast<std::uint32_t>(value);
  }
  return code;
}

/// A key as shown in messages: without control bytes, at most 80 bytes.
std::string shownKey(const std::string& key) {
  std::string out;
  for (char c : std::string_view(key).substr(0, 80)) {
    out.push_back(static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c);
  }
  while (key.size() > 80 && !out.empty() && (out.back() & 0x80) != 0) out.pop_back();
  return key.size() > 80 ? out + "…" : out;
}

}  // namespace

std::string unescapeJson(std::string_view inner) {
  std::string out;
  out.reserve(inner.size());
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (inner[i] != '\\') {
      out.push_back(inner[i]);
      continue;
    }
    const char c = inner[++i];
    if (c != 'u') {
      const std::size_t known = std::string_view("bfnrt").find(c);
      out.push_back(known == std::string_view::npos ? c : "\b\f\n\r\t"[known]);
      continue;
    }
    std::uint32_t code = hexCode(inner.substr(i + 1, 4));
    i += 4;
    if (code >= 0xD800 && code < 0xDC00 && inner.substr(i + 1, 2) == "\\u") {
      const std::uint32_t low = hexCode(inner.substr(i + 3, 4));
      if (low >= 0xDC00 && low < 0xE000) {
        code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
        i += 6;
      }
    }
    appendUtf8(out, code >= 0xD800 && code < 0xE000 ? 0xFFFD : code);
  }
  return out;
}

std::string quoteJson(std::string_view value) {
  std::string out = "\"";
  for (char c : value) {
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      out += formatText("\\u%04x", static_cast<unsigned>(c));
    } else {
      out.push_back(c);
    }
  }
  out.push_back('"');
  return out;
}

std::string JsonText::key(int i) const {
  const JsonNode& n = node(i);
  if (n.keyEnd == n.keyBegin) return {};
  return unescapeJson(std::string_view(text_).substr(n.keyBegin + 1, n.keyEnd - n.keyBegin - 2));
}

int JsonText::find(int object, std::string_view wanted) const {
  if (!isObject(object)) return -1;
  for (int c = firstChild(object); c >= 0; c = node(c).next) {
    const JsonNode& n = node(c);
    const auto inner = std::string_view(text_).substr(n.keyBegin + 1, n.keyEnd - n.keyBegin - 2);
    if (inner == wanted) return c;
    if (inner.find('\\') != std::string_view::npos && unescapeJson(inner) == wanted) return c;
  }
  return -1;
}

std::vector<int> JsonText::children(int i) const {
  std::vector<int> out;
  if (!isArray(i) && !isObject(i)) return out;
  out.reserve(static_cast<std::size_t>(node(i).count));
  for (int c = firstChild(i); c >= 0; c = node(c).next) out.push_back(c);
  return out;
}

std::string_view JsonText::raw(int i) const {
  if (i < 0) return {};
  return std::string_view(text_).substr(node(i).begin, node(i).end - node(i).begin);
}

std::string JsonText::string(int i) const {
  if (!isString(i)) return {};
  const std::string_view quotedText = raw(i);
  return unescapeJson(quotedText.substr(1, quotedText.size() - 2));
}

std::optional<std::int64_t> JsonText::integer(int i) const {
  if (!isKind(i, JsonKind::kNumber)) return std::nullopt;
  const std::string_view literal = raw(i);
  if (literal.size() > 17 || literal.find_first_of(".eE") != std::string_view::npos) {
    return std::nullopt;
  }
  std::int64_t value = 0;
  const char* p = literal.data();
  if (!text::readInt(p, literal.data() + literal.size(), value)) return std::nullopt;
  if (value > (std::int64_t{1} << 53) || value < -(std::int64_t{1} << 53)) return std::nullopt;
  return value;
}

std::optional<double> JsonText::number(int i) const {
  if (!isKind(i, JsonKind::kNumber)) return std::nullopt;
  const std::string_view literal = raw(i);
  const char* p = literal.data();
  double value = 0;
  if (!text::readDouble(p, literal.data() + literal.size(), value) || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string JsonText::pointer(int i) const {
  std::vector<std::string> parts;
  for (; i > kRoot; i = node(i).parent) {
    const int parent = node(i).parent;
    if (node(i).keyEnd > node(i).keyBegin) {
      parts.push_back(shownKey(key(i)));
      continue;
    }
    int position = 0;
    for (int c = firstChild(parent); c != i; c = node(c).next) ++position;
    parts.push_back(std::to_string(position));
  }
  std::string out;
  for (auto part = parts.rbegin(); part != parts.rend(); ++part) {
    out.push_back('/');
    for (char c : *part) {
      if (c == '~') {
        out += "~0";
      } else if (c == '/') {
        out += "~1";
      } else {
        out.push_back(c);
      }
    }
  }
  return out;
}

}  // namespace hgp::io
