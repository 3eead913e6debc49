#include <cstring>
#include <optional>
#include <string>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/polygon_document.h"
#include "hgp/io/weld.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kTriangleBytes = 50;

std::uint32_t littleUint32(const std::uint8_t* p) {
  return static_cast<std::uint32_t>(p[0]) | static_cast<std::uint32_t>(p[1]) << 8 |
         static_cast<std::uint32_t>(p[2]) << 16 | static_cast<std::uint32_t>(p[3]) << 24;
}

double littleFloat(const std::uint8_t* p) {
  const std::uint32_t b = littleUint32(p);
  float x = 0;
  std::memcpy(&x, &b, sizeof x);
  return static_cast<double>(x);
}

Result<std::vector<Vec3>> readBinary(const Bytes& bytes, std::size_t count) {
  std::vector<Vec3> corners;
  corners.reserve(3 * count);
  for (std::size_t t = 0; t < count; ++t) {
    const std::uint8_t* p = bytes.data() + kHeaderBytes + t * kTriangleBytes + 12;
    for (int k = 0; k < 3; ++k, p += 12) {
      corners.push_back({littleFloat(p), littleFloat(p + 4), littleFloat(p + 8)});
    }
  }
  return corners;
}

/// The word in lower case: some programs write upper case.
std::string lower(std::string_view word) {
  std::string out(word);
  for (char& c : out) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
  }
  return out;
}

Result<std::vector<Vec3>> readText(std::string_view text) {
  text::WordReader words(text);
  if (lower(words.next()) != "solid") {
    return text::malformedLine(words.line(), "not an STL file (the first word must be solid)");
  }
  words.restOfLine();
  std::vector<Vec3> corners;
  while (!words.isAtEnd()) {
    const std::string word = lower(words.next());
    if (word == "vertex") {
      Vec3 p{};
      for (double& x : p) {
        if (!words.nextDouble(x)) {
          return text::malformedLine(words.line(),
                                     "expected a number, not " + text::inQuotes(words.word()));
        }
      }
      corners.push_back(p);
    } else if (word == "endloop") {
      if (corners.size() % 3 != 0) {
        return text::malformedLine(words.line(), "a loop that does not have 3 vertices");
      }
    } else if (word == "solid" || word == "endsolid" || word == "facet" || word == "color") {
      words.restOfLine();
    } else if (word != "outer" && word != "loop" && word != "endfacet") {
      return text::malformedLine(words.line(), "unexpected word " + text::inQuotes(word));
    }
  }
  if (corners.size() % 3 != 0) {
    return text::malformedLine(words.line(),
                               "the last facet is incomplete; the file may be truncated");
  }
  return corners;
}

/// How many triangles a binary file has; empty if it is text or truncated. Some programs leave the count
/// at 0, others append bytes after the last triangle.
std::optional<std::size_t> binaryCount(const Bytes& bytes, Notes& notes) {
  if (bytes.size() < kHeaderBytes) return std::nullopt;
  const std::size_t announced = littleUint32(bytes.data() + 80);
  const std::size_t room = (bytes.size() - kHeaderBytes) / kTriangleBytes;
  const std::size_t left = bytes.size() - kHeaderBytes - room * kTriangleBytes;
  if (announced > 0 && announced == room && left == 0) return announced;
  if (isStlText(asText(bytes))) return std::nullopt;
  if (announced == 0 && room > 0 && left == 0) {
    notes.push_back(Note("read-stl-count", {{"triangles", room}}));
    return room;
  }
  if (announced == 0 || announced > room) return std::nullopt;
  const std::size_t behind = bytes.size() - kHeaderBytes - announced * kTriangleBytes;
  notes.push_back(Note("read-stl-longer", {{"bytes", behind}}));
  return announced;
}

}  // namespace

bool isStlText(std::string_view text) {
  text::WordReader words(withoutByteOrderMark(text.substr(0, 4096)));
  if (lower(words.next()) != "solid") return false;
  // A binary header may also begin with "solid", but then a zero byte follows soon.
  return text.substr(0, 512).find('\0') == std::string_view::npos;
}

Result<DocumentPtr> readStl(const FileSet& files, const Limits& limits) {
  const Bytes& bytes = files.main;
  PolygonFile file;
  const std::optional<std::size_t> count = binaryCount(bytes, file.notes);
  if (!count && !isStlText(asText(bytes))) {
    const std::size_t announced = bytes.size() < kHeaderBytes ? 0 : littleUint32(&bytes[80]);
    return text::malformedByte(80, formatText("not an STL file, or a truncated one: %s announced "
                                              "in a file of %s",
                                              counted(announced, "triangle").c_str(),
                                              counted(bytes.size(), "byte").c_str()));
  }
  if (count && *count > limits.maxTriangles) {
    return tooManyTriangles(*count, limits.maxTriangles);
  }
  Result<std::vector<Vec3>> corners =
      count ? readBinary(bytes, *count) : readText(withoutByteOrderMark(asText(bytes)));
  if (!corners) return corners.error();
  if (corners->empty()) return text::malformedByte(bytes.size(), "there are no triangles");
  if (corners->size() / 3 > limits.maxTriangles) {
    return tooManyTriangles(corners->size() / 3, limits.maxTriangles);
  }
  Weld weld = weldExact(*corners);
  file.storedVertexCount = static_cast<int>(corners->size());
  file.polygons.positions = std::move(weld.positions);
  file.polygons.cornerVertex = std::move(weld.welded);
  for (std::size_t c = 3; c <= corners->size(); c += 3) {
    file.polygons.start.push_back(static_cast<std::uint32_t>(c));
  }
  file.notes.push_back(Note("read-joined-equal"));
  return PolygonDocument::make("stl", std::move(file));
}

}  // namespace hgp::io
