#include "hgp/io/gltf/decode/draco_header.h"

#include "hgp/base/check.h"

namespace hgp::io {
namespace {

constexpr int kDeepestMetadata = 64;

/// Reads bytes in order; every step returns whether enough of them were left.
class DracoCursor {
 public:
  explicit DracoCursor(ByteView bytes) : bytes_(bytes) {}

  bool byte(std::uint32_t& out) {
    if (at_ >= bytes_.size()) return false;
    out = bytes_[at_++];
    return true;
  }

  bool varint(std::uint64_t& out) {
    out = 0;
    std::uint32_t b = 0x80;
    for (int shift = 0; (b & 0x80) != 0; shift += 7) {
      if (shift > 35 || !byte(b)) return false;
      out |= std::uint64_t{b & 0x7F} << shift;
    }
    return true;
  }

  bool skip(std::uint64_t count) {
    if (count > bytes_.size() - at_) return false;
    at_ += count;
    return true;
  }

  bool skipName() {
    std::uint32_t length = 0;
    return byte(length) && skip(length);
  }

  bool skipMetadata(int depth) {
    std::uint64_t entries = 0, children = 0, size = 0;
    if (depth > kDeepestMetadata || !varint(entries)) return false;
    for (std::uint64_t k = 0; k < entries; ++k) {
      if (!skipName() || !varint(size) || !skip(size)) return false;
    }
    if (!varint(children)) return false;
    for (std::uint64_t k = 0; k < children; ++k) {
      if (!skipName() || !skipMetadata(depth + 1)) return false;
    }
    return true;
  }

 private:
  ByteView bytes_;
  std::size_t at_ = 0;
};

}  // namespace

Status checkDracoHeader(const DracoRequest& request) {
  const auto refuse = [](const std::string& what) {
    return Failure{ErrorCode::kMalformed, "read", "the Draco data " + what, {}};
  };
  const ByteView bytes = request.source;
  const bool hasMagic = bytes.size() >= 11 && bytes[0] == 'D' && bytes[1] == 'R' &&
                        bytes[2] == 'A' && bytes[3] == 'C' && bytes[4] == 'O';
  if (!hasMagic) return refuse("does not start like Draco data");
  if (bytes[5] != 2 || bytes[6] != 2) {
    return refuse(formatText("has bitstream version %d.%d; glTF uses 2.2", bytes[5], bytes[6]));
  }
  if (bytes[7] != 1) return refuse("is a point cloud, not a mesh");
  DracoCursor cursor(bytes.subspan(11));
  if ((bytes[10] & 0x80) != 0) {
    std::uint64_t count = 0, id = 0;
    bool isGood = cursor.varint(count);
    for (std::uint64_t k = 0; isGood && k < count; ++k) {
      isGood = cursor.varint(id) && cursor.skipMetadata(0);
    }
    if (!isGood || !cursor.skipMetadata(0)) return refuse("has damaged metadata");
  }
  const bool isEdgebreaker = bytes[8] == 1;
  std::uint64_t faces = 0, vertices = 0;
  std::uint32_t traversal = 0;
  const bool isGood =
      isEdgebreaker ? cursor.byte(traversal) && cursor.varint(vertices) && cursor.varint(faces)
                    : cursor.varint(faces) && cursor.varint(vertices);
  if (!isGood) return refuse("is cut off");
  if (faces * 3 != request.indexCount || vertices > request.vertexCount) {
    return refuse(formatText(
        "claims %llu vertices and %llu triangles, but the accessors have %llu "
        "vertices and %llu indices",
        static_cast<unsigned long long>(vertices), static_cast<unsigned long long>(faces),
        static_cast<unsigned long long>(request.vertexCount),
        static_cast<unsigned long long>(request.indexCount)));
  }
  return Done{};
}

}  // namespace hgp::io
