#include <cstring>

#include "hgp/base/check.h"
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

Result<std::vector<Vec3>> readText(std::string_view text) {
  WordReader words(text);
  if (words.next() != "solid") return malformedLine(words.line(), "not an STL file");
  words.restOfLine();
  std::vector<Vec3> corners;
  while (!words.isAtEnd()) {
    const std::string_view word = words.next();
    if (word == "vertex") {
      Vec3 p{};
      for (double& x : p) {
        if (!words.nextDouble(x)) {
          return malformedLine(words.line(), "expected a number, not " + inQuotes(words.word()));
        }
      }
      corners.push_back(p);
    } else if (word == "endloop") {
      if (corners.size() % 3 != 0) return malformedLine(words.line(), "a loop without 3 vertices");
    } else if (word == "solid" || word == "endsolid" || word == "facet") {
      words.restOfLine();
    } else if (word != "outer" && word != "loop" && word != "endfacet") {
      return malformedLine(words.line(), "unexpected word " + inQuotes(word));
    }
  }
  if (corners.size() % 3 != 0) return malformedLine(words.line(), "the last facet is not complete");
  return corners;
}

}  // namespace

Result<DocumentPtr> readStl(const FileSet& files, const Limits& limits) {
  const Bytes& bytes = files.main;
  const std::size_t announced = bytes.size() < kHeaderBytes ? 0 : littleUint32(bytes.data() + 80);
  const bool isBinary = bytes.size() >= kHeaderBytes &&
                        announced == (bytes.size() - kHeaderBytes) / kTriangleBytes &&
                        (bytes.size() - kHeaderBytes) % kTriangleBytes == 0;
  if (!isBinary && asText(bytes).substr(0, 5) != "solid") {
    return malformedByte(80, formatText("not an STL file, or a truncated one: %zu triangles are "
                                        "announced in %zu bytes",
                                        announced, bytes.size()));
  }
  if (isBinary && announced > limits.maxTriangles) {
    return Failure{
        ErrorCode::kLimit, "read", formatText("%zu triangles exceed the limit", announced), {}};
  }
  Result<std::vector<Vec3>> corners =
      isBinary ? readBinary(bytes, announced) : readText(asText(bytes));
  if (!corners) return corners.error();
  if (corners->empty()) return malformedByte(bytes.size(), "there are no triangles");
  if (corners->size() / 3 > limits.maxTriangles) {
    return Failure{ErrorCode::kLimit, "read", "more triangles than the limit allows", {}};
  }
  Weld weld = weldExact(*corners);
  PolygonFile file;
  file.storedVertexCount = static_cast<int>(corners->size());
  file.polygons.positions = std::move(weld.positions);
  file.polygons.cornerVertex = std::move(weld.welded);
  for (std::size_t c = 3; c <= corners->size(); c += 3) {
    file.polygons.start.push_back(static_cast<std::uint32_t>(c));
  }
  file.notes.push_back("vertices at equal positions were joined (STL has no connectivity)");
  return PolygonDocument::make("stl", std::move(file));
}

}  // namespace hgp::io
