// A glTF asset as bytes: JSON text, binary chunk and the files that it names.  Role: the container, and the
// rules for which URIs may be read.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/io/document.h"
#include "hgp/io/gltf/json/json.h"

namespace hgp::io {

/// A chunk of a GLB other than JSON and BIN, kept for writing.
struct GltfChunk {
  std::uint32_t type = 0;
  ByteView bytes;
};

/// The parts of the container. Views refer to the file's bytes.
struct GltfContainer {
  bool isBinary = false;
  std::string_view json;
  bool hasBin = false;
  ByteView bin;
  std::vector<GltfChunk> others;
  Notes notes;  ///< about wrong lengths that were tolerated
};

/// Distinguishes GLB from JSON and checks every length of a GLB. Fails with kMalformed at a byte. Accepted with
/// a note: bytes after the end, a header that states too small a length although the chunks fill the file, and
/// chunks without padding.
Result<GltfContainer> openContainer(ByteView file);

/// The parts of "data:…;base64,…", not decoded; fails for any other URI.
struct DataUri {
  std::string_view base64;
};
bool isDataUri(std::string_view uri);
Result<DataUri> parseDataUri(std::string_view uri);

/// The number of bytes of a base64 text, without decoding it, and the bytes; empty if it is not well formed.
std::optional<std::size_t> decodedSize(std::string_view base64);
std::optional<Bytes> decodeBase64(std::string_view base64);
std::string encodeBase64(ByteView bytes);

/// The relative file name that a URI denotes, percent-decoded once. Fails if the name is absolute, leaves its
/// folder, has a scheme, host, drive, backslash or control character, or if the URI has a '?' or '#' that is
/// not encoded.
Result<std::string> relativeName(std::string_view uri);

/// "a" of "b/a.glb", with which the names of side files begin.
std::string fileStem(const std::string& name);
/// stem + ".bin", with a number before the dot if that name is already in `taken`.
std::string freeSideName(const std::string& stem, const std::vector<std::string>& taken);

/// Percent-encodes the characters that a URI cannot contain.
std::string uriFromName(std::string_view name);

}  // namespace hgp::io
