#include "hgp/io/polygon/ply_header.h"

#include <cstring>

#include "hgp/text/nearest.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

bool typeOf(std::string_view name, PlyType& out) {
  struct Name {
    std::string_view text;
    PlyType type;
  };
  static constexpr Name kNames[] = {
      {"char", PlyType::kInt8},      {"int8", PlyType::kInt8},       {"uchar", PlyType::kUint8},
      {"uint8", PlyType::kUint8},    {"short", PlyType::kInt16},     {"int16", PlyType::kInt16},
      {"ushort", PlyType::kUint16},  {"uint16", PlyType::kUint16},   {"int", PlyType::kInt32},
      {"int32", PlyType::kInt32},    {"uint", PlyType::kUint32},     {"uint32", PlyType::kUint32},
      {"float", PlyType::kFloat32},  {"float32", PlyType::kFloat32}, {"double", PlyType::kFloat64},
      {"float64", PlyType::kFloat64}};
  for (const Name& n : kNames) {
    if (n.text != name) continue;
    out = n.type;
    return true;
  }
  return false;
}

PlyRole roleOf(std::string_view name) {
  if (name == "x") return PlyRole::kX;
  if (name == "y") return PlyRole::kY;
  if (name == "z") return PlyRole::kZ;
  if (name == "s" || name == "u" || name == "texture_u") return PlyRole::kU;
  if (name == "t" || name == "v" || name == "texture_v") return PlyRole::kV;
  if (name == "vertex_indices" || name == "vertex_index") return PlyRole::kCorners;
  if (name == "texcoord") return PlyRole::kUvList;
  if (name == "nx") return PlyRole::kNormalX;
  if (name == "ny") return PlyRole::kNormalY;
  if (name == "nz") return PlyRole::kNormalZ;
  if (name == "red" || name == "diffuse_red") return PlyRole::kRed;
  if (name == "green" || name == "diffuse_green") return PlyRole::kGreen;
  if (name == "blue" || name == "diffuse_blue") return PlyRole::kBlue;
  if (name == "alpha") return PlyRole::kAlpha;
  return PlyRole::kNone;
}

bool takeProperty(text::WordReader& words, PlyHeader& header) {
  if (header.elements.empty()) return false;
  PlyProperty property;
  std::string_view type = words.next();
  if (type == "list") {
    property.isList = true;
    if (!typeOf(words.next(), property.countType)) return false;
    type = words.next();
  }
  if (!typeOf(type, property.type)) return false;
  property.name = words.next();
  property.role = roleOf(property.name);
  header.elements.back().properties.push_back(property);
  return true;
}

bool takeLine(std::string_view line, PlyHeader& header) {
  text::WordReader words(line);
  const std::string_view keyword = words.next();
  if (keyword == "format") {
    const std::string_view encoding = words.next();
    if (encoding == "ascii")
      header.encoding = PlyEncoding::kText;
    else if (encoding == "binary_little_endian")
      header.encoding = PlyEncoding::kLittle;
    else if (encoding == "binary_big_endian")
      header.encoding = PlyEncoding::kBig;
    else
      return false;
    return true;
  }
  if (keyword == "element") {
    PlyElement element;
    element.name = std::string(words.next());
    std::int64_t count = 0;
    if (!words.nextInt(count) || count < 0) return false;
    element.count = static_cast<std::uint64_t>(count);
    header.elements.push_back(std::move(element));
    return header.elements.size() <= 64;
  }
  if (keyword == "property") return takeProperty(words, header);
  if (keyword == "comment" || keyword == "obj_info" || keyword == "ply" || keyword.empty())
    return true;
  // A mistyped property would change what all numbers mean.
  if (!text::nearestOf(std::string(keyword.substr(0, 40)),
                       {"property", "element", "format", "end_header"})
           .empty())
    return false;
  ++header.unknownLines;
  return true;
}

template <class T>
double numberAs(const unsigned char* bytes) {
  T x;
  std::memcpy(&x, bytes, sizeof x);
  return static_cast<double>(x);
}

}  // namespace

Result<PlyHeader> readPlyHeader(std::string_view text) {
  PlyHeader header;
  if (text.substr(0, 3) != "ply") {
    return text::malformedByte(0, "not a PLY file (the first word must be ply)");
  }
  // A binary body may contain any byte, so the line ending is taken from the first line.
  const std::size_t first = text.find_first_of("\r\n");
  const bool isOld =
      first != std::string_view::npos && text[first] == '\r' && text.substr(first + 1, 1) != "\n";
  const char lineEnd = isOld ? '\r' : '\n';
  header.lineEnd = isOld ? PlyLineEnd::kOld : PlyLineEnd::kNew;
  std::size_t position = 0;
  while (position < text.size()) {
    const std::size_t end = text.find(lineEnd, position);
    if (end == std::string_view::npos || position > (std::size_t{1} << 20)) break;
    std::string_view line = text.substr(position, end - position);
    ++header.lineCount;
    position = end + 1;
    while (!line.empty() && text::isBlank(line.back())) line.remove_suffix(1);
    if (line == "end_header") {
      header.bodyOffset = position;
      return header;
    }
    if (!takeLine(line, header)) {
      return text::malformedLine(header.lineCount,
                                 "unknown line in the PLY header: " + text::inQuotes(line));
    }
  }
  return text::malformedByte(position, "the PLY header has no end (end_header is missing)");
}

std::size_t plySize(PlyType type) {
  switch (type) {
    case PlyType::kInt8:
    case PlyType::kUint8:
      return 1;
    case PlyType::kInt16:
    case PlyType::kUint16:
      return 2;
    case PlyType::kFloat64:
      return 8;
    default:
      return 4;
  }
}

double plyNumber(PlyType type, const unsigned char* bytes) {
  switch (type) {
    case PlyType::kInt8:
      return numberAs<std::int8_t>(bytes);
    case PlyType::kUint8:
      return numberAs<std::uint8_t>(bytes);
    case PlyType::kInt16:
      return numberAs<std::int16_t>(bytes);
    case PlyType::kUint16:
      return numberAs<std::uint16_t>(bytes);
    case PlyType::kInt32:
      return numberAs<std::int32_t>(bytes);
    case PlyType::kUint32:
      return numberAs<std::uint32_t>(bytes);
    case PlyType::kFloat32:
      return numberAs<float>(bytes);
    default:
      return numberAs<double>(bytes);
  }
}

}  // namespace hgp::io
