// A glTF asset as bytes: JSON text, binary chunk, and the files it names.  Role: the container and
// every path by which bytes enter; decides what a URI may mean.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/gltf_json.h"

namespace hgp::io {

/// A chunk of a GLB other than JSON and BIN, kept for writing.
struct GltfChunk {
  std::uint32_t type = 0;
  ByteView bytes;
};

/// The container taken apart. Views point into the file's bytes.
struct GltfContainer {
  bool isBinary = false;
  std::string_view json;
  bool hasBin = false;
  ByteView bin;
  std::vector<GltfChunk> others;
  std::vector<std::string> notes;  ///< which lengths are not what they should be
};

/// Tells GLB and JSON apart and checks every length of a GLB. kMalformed names the byte. With a note: bytes
/// behind the end, a header that says too little where the chunks fill the file, chunks without padding.
Result<GltfContainer> openContainer(ByteView file);

/// "data:…;base64,…" taken apart without decoding; nothing for any other URI.
struct DataUri {
  std::string_view base64;
};
bool isDataUri(std::string_view uri);
Result<DataUri> parseDataUri(std::string_view uri);

/// Decodes base64; nothing when it is not well formed. `decodedSize` costs no memory.
std::optional<std::size_t> decodedSize(std::string_view base64);
std::optional<Bytes> decodeBase64(std::string_view base64);
std::string encodeBase64(ByteView bytes);

/// The relative name that a URI stands for: percent-decoded once, then refused when it is absolute,
/// leaves its folder, names a scheme, host, drive or backslash, holds control characters, or '?' or '#' that
/// are not encoded.
Result<std::string> relativeName(std::string_view uri);

/// "a" of "b/a.glb": what names of side files begin with.
std::string fileStem(const std::string& name);
/// stem + ".bin", with a number before the dot where that is taken.
std::string freeSideName(const std::string& stem, const std::vector<std::string>& taken);

/// Percent-encodes what a URI cannot hold.
std::string uriFromName(std::string_view name);

}  // namespace hgp::io
