#include <algorithm>
#include <cstring>

#include "hgp/base/check.h"
#include "hgp/io/document.h"
#include "hgp/io/limits.h"
#include "hgp/io/polygon/polygon_document.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

std::string extensionOf(const std::string& name) {
  const std::size_t dot = name.find_last_of('.');
  const std::size_t slash = name.find_last_of('/');
  if (dot == std::string::npos || (slash != std::string::npos && slash > dot)) return "";
  std::string extension = name.substr(dot + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

/// The size that a binary STL must have by the count in its header; 0 if the file is too short for a count.
std::uint64_t binaryStlSize(const Bytes& bytes) {
  if (bytes.size() < 84) return 0;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) count |= static_cast<std::uint64_t>(bytes[80 + i]) << (8 * i);
  return count > 0 ? 84 + 50 * count : 0;
}

/// For input without a name (standard input): text has no zero byte, and the other binary formats were
/// recognized before.
bool isNamelessStl(const Bytes& bytes, const std::string& extension) {
  const std::uint64_t size = extension.empty() ? binaryStlSize(bytes) : 0;
  return size > 0 && bytes.size() > size &&
         std::memchr(bytes.data(), 0, std::min<std::size_t>(bytes.size(), 4096)) != nullptr;
}

}  // namespace

Result<DocumentPtr> openDocument(FileSet files, const Limits& limits) {
  if (files.main.size() > limits.maxBytes) {
    return tooManyBytes(files.main.size(), limits.maxBytes);
  }
  if (files.main.empty()) return text::malformedByte(0, "the file is empty");
  const std::string_view text = withoutByteOrderMark(asText(files.main));
  const auto startsWith = [&](std::string_view start) {
    return text.substr(0, start.size()) == start;
  };
  if (startsWith("glTF")) return readGltf(std::move(files), limits);
  if (startsWith("ply")) return readPly(std::move(files), limits);
  if (files.main.size() == binaryStlSize(files.main)) return readStl(files, limits);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const char c = first == std::string_view::npos ? '\0' : text[first];
  const std::string extension = extensionOf(files.name);
  if (isNamelessStl(files.main, extension)) return readStl(files, limits);
  if (c == '{' || extension == "gltf" || extension == "glb")
    return readGltf(std::move(files), limits);
  if (c == '<') return text::malformedByte(first, "this is HTML or XML, not a mesh");
  if (isStlText(text) && extension != "obj") return readStl(files, limits);
  if (extension == "off" || extension == "stl" || extension == "ply") {
    if (extension == "off") return readOff(std::move(files), limits);
    if (extension == "stl") return readStl(files, limits);
    return readPly(std::move(files), limits);
  }
  text::WordReader words(text.substr(0, std::min<std::size_t>(text.size(), 4096)));
  const std::string_view word = words.next();
  if (extension != "obj" && word.size() >= 3 && word.substr(word.size() - 3) == "OFF") {
    return readOff(std::move(files), limits);
  }
  return readObj(std::move(files), limits);
}

Result<WrittenMaps> Document::writeAll(const std::vector<SurfaceUv>&, const WriteOptions&) const {
  return Failure{ErrorCode::kUnsupported,
                 "write",
                 std::string("a file in the format ") + format() + " has one mesh",
                 {}};
}

}  // namespace hgp::io
