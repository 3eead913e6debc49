#include "hgp/quads/write_quads.h"

#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"

namespace hgp {
namespace {

class ByteWriter {
 public:
  void word(std::uint32_t x) {
    for (int k = 0; k < 4; ++k) bytes_.push_back(static_cast<std::uint8_t>(x >> (8 * k)));
  }
  void number(double x) {
    const auto rounded = static_cast<float>(x);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &rounded, sizeof bits);
    word(bits);
  }
  void text(const std::string& s, char pad) {
    bytes_.insert(bytes_.end(), s.begin(), s.end());
    while (bytes_.size() % 4 != 0) bytes_.push_back(static_cast<std::uint8_t>(pad));
  }
  std::vector<std::uint8_t>& bytes() { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

/// The smallest or largest float32 per coordinate, as JSON.
std::string bound(const std::vector<Vec3>& points, bool isLow) {
  std::string out;
  for (std::size_t k = 0; k < 3; ++k) {
    float best = points.empty() ? 0.0F : static_cast<float>(points[0][k]);
    for (const Vec3& p : points) {
      const auto x = static_cast<float>(p[k]);
      best = isLow ? std::min(best, x) : std::max(best, x);
    }
    out += formatText("%s%.9g", k == 0 ? "[" : ",", static_cast<double>(best));
  }
  return out + "]";
}

}  // namespace

std::string quadsAsObj(const QuadMesh& quads, const std::string& comment) {
  std::string out = "# " + comment + "\n";
  for (const Vec3& p : quads.positions)
    out += formatText("v %.17g %.17g %.17g\n", p[0], p[1], p[2]);
  for (const Vec3& n : quads.normals) out += formatText("vn %.9g %.9g %.9g\n", n[0], n[1], n[2]);
  for (const auto& q : quads.quads) {
    out += "f";
    for (int v : q) out += formatText(" %d//%d", v + 1, v + 1);
    out += "\n";
  }
  return out;
}

std::vector<std::uint8_t> quadsAsGlb(const QuadMesh& quads, const std::string& generator) {
  const std::size_t points = quads.positions.size(), corners = 6 * quads.quads.size();
  ByteWriter data;
  for (const auto* list : {&quads.positions, &quads.normals})
    for (const Vec3& p : *list)
      for (double x : p) data.number(x);
  for (const auto& q : quads.quads)
    for (int k : {0, 1, 2, 0, 2, 3})
      data.word(static_cast<std::uint32_t>(q[static_cast<std::size_t>(k)]));
  std::string json = "{\"asset\":{\"version\":\"2.0\",\"generator\":\"" + generator +
                     "\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],"
                     "\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0,\"NORMAL\":1},"
                     "\"indices\":2}]}],";
  json += formatText("\"buffers\":[{\"byteLength\":%zu}],\"bufferViews\":[", data.bytes().size());
  json += formatText("{\"buffer\":0,\"byteOffset\":0,\"byteLength\":%zu,\"target\":34962},",
                     12 * points);
  json += formatText("{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":34962},",
                     12 * points, 12 * points);
  json += formatText("{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":34963}],",
                     24 * points, 4 * corners);
  json += formatText(
              "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":%zu,"
              "\"type\":\"VEC3\",\"min\":",
              points) +
          bound(quads.positions, true) + ",\"max\":" + bound(quads.positions, false);
  json += formatText(
      "},{\"bufferView\":1,\"componentType\":5126,\"count\":%zu,\"type\":\"VEC3\"},"
      "{\"bufferView\":2,\"componentType\":5125,\"count\":%zu,\"type\":\"SCALAR\"}]}",
      points, corners);
  ByteWriter head;
  head.text(json, ' ');
  ByteWriter out;
  const auto jsonSize = static_cast<std::uint32_t>(head.bytes().size());
  const auto dataSize = static_cast<std::uint32_t>(data.bytes().size());
  out.word(0x46546C67);
  out.word(2);
  out.word(12 + 8 + jsonSize + 8 + dataSize);
  out.word(jsonSize);
  out.word(0x4E4F534A);
  out.bytes().insert(out.bytes().end(), head.bytes().begin(), head.bytes().end());
  out.word(dataSize);
  out.word(0x004E4942);
  out.bytes().insert(out.bytes().end(), data.bytes().begin(), data.bytes().end());
  return out.bytes();
}

}  // namespace hgp
