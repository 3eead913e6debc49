#include "hgp/io/gltf/patch/write.h"

#include <cstring>

#include "hgp/base/check.h"
#include "hgp/io/gltf/patch/writer.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

void appendWord(Bytes& out, std::uint64_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    out.push_back(static_cast<std::uint8_t>(value >> shift & 0xFF));
  }
}

void appendChunk(Bytes& out, std::uint32_t type, ByteView content, std::uint8_t padding) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  appendWord(out, padded);
  appendWord(out, type);
  out.insert(out.end(), content.begin(), content.end());
  out.insert(out.end(), padded - content.size(), padding);
}

}  // namespace

Result<Written> writeGltf(const GltfStore& store, const GltfSurface& part, const UvMap& map,
                          const WriteOptions& options) {
  Result<WrittenMaps> written = writeGltfMaps(
      store, {{&part, &map, options.cones, options.uvSet, options.pointsMaterials}}, options);
  if (!written) return written.error();
  Notes& notes = written->mapNotes.front();
  notes.insert(notes.end(), written->notes.begin(), written->notes.end());
  written->notes = std::move(notes);
  return Written(std::move(*written));
}

Result<WrittenMaps> writeGltfMaps(const GltfStore& store, const std::vector<GltfMap>& maps,
                                  const WriteOptions& options) {
  GltfWriter writer(store, options);
  WrittenMaps out;
  for (const GltfMap& one : maps) {
    auto notes = writer.add(one);
    if (!notes) return notes.error();
    out.mapNotes.push_back(std::move(*notes));
  }
  Result<Written> written = writer.finish();
  if (!written) return written.error();
  static_cast<Written&>(out) = std::move(*written);
  return out;
}

Result<Bytes> packContainer(const GltfContainer& container, const std::string& json, ByteView bin) {
  if (!container.isBinary) return asBytes(json);
  Bytes out;
  std::uint64_t total = 12 + 8 + json.size() + 3 + 8 + bin.size() + 3;
  for (const GltfChunk& chunk : container.others) total += 8 + chunk.bytes.size();
  if (total > UINT32_MAX) {
    return Failure{ErrorCode::kLimit, "write", "a GLB cannot be larger than 4 GiB", {}};
  }
  out.reserve(total);
  appendWord(out, 0x46546C67);
  appendWord(out, 2);
  appendWord(out, 0);
  appendChunk(out, 0x4E4F534A, {reinterpret_cast<const std::uint8_t*>(json.data()), json.size()},
              ' ');
  if (container.hasBin) appendChunk(out, 0x004E4942, bin, 0);
  for (const GltfChunk& chunk : container.others) appendChunk(out, chunk.type, chunk.bytes, 0);
  const std::uint64_t length = out.size();
  for (std::size_t k = 0; k < 4; ++k)
    out[8 + k] = static_cast<std::uint8_t>(length >> 8 * k & 0xFF);
  return out;
}

Result<Bytes> packGltf(const GltfStore& store, const std::string& json, ByteView bin) {
  return packContainer(store.container, json, bin);
}

}  // namespace hgp::io
