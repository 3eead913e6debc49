// Options and results of writing a file.  Role: the argument and return types of Document::write.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hgp/base/note.h"

namespace hgp {
struct UvMap;
}

namespace hgp::io {
class Document;

using Bytes = std::vector<std::uint8_t>;
/// Copies the text in one step, since appending byte by byte is slow for large meshes.
inline Bytes asBytes(const std::string& text) {
  const auto* first = reinterpret_cast<const std::uint8_t*>(text.data());
  return Bytes(first, first + text.size());
}
using ByteView = std::span<const std::uint8_t>;

struct WriteOptions {
  std::string format;     ///< one that canWriteAs allows; "": outputFormat()
  int uvSet = -1;         ///< −1: own set or next free; otherwise the set to add or replace
  std::string name;       ///< of the main output; names of side files derive from it
  std::string generator;  ///< stamped into a comment where the format has one, or ""
  std::optional<std::string> cones;  ///< hgp-cones JSON to embed for re-opening
  /// glTF: whether the materials' textures use the written set; unset: those whose own set is missing or without area.
  std::optional<bool> pointsMaterials;
  bool isSideFileNoted = true;     ///< adds the note "keep x.bin next to the new file"
  bool isCompressedLater = false;  ///< glTF: omits notes on what is stored uncompressed
};

struct OutputFile {
  std::string name;  ///< relative to the main output's folder; [0] is the main file
  Bytes bytes;
};

struct Written {
  std::vector<OutputFile> files;
  Notes notes;            ///< what changed besides the uv ("TANGENT dropped …")
  std::vector<int> xref;  ///< written vertex → stored vertex; empty when identical
};

/// A map for Document::writeAll.
struct SurfaceUv {
  const Document* document = nullptr;  ///< the one that writes, or the result of its repaired()
  int surface = 0;
  const UvMap* map = nullptr;
  std::optional<std::string> cones;
  int uvSet = -1;                       ///< as WriteOptions::uvSet, for this map
  std::optional<bool> pointsMaterials;  ///< likewise
};

/// The maps of several surfaces, written at once.
struct WrittenMaps : Written {  // its notes are on the file as a whole, xref is empty
  std::vector<Notes> mapNotes;  ///< by map
};

}  // namespace hgp::io
