#include "hgp/io/convert.h"

#include "hgp/base/check.h"
#include "hgp/io/gltf/pack/pack.h"
#include "hgp/io/plain_surface.h"

namespace hgp::io {

bool canConvert(const Document& document, std::string_view format) {
  const std::string_view own = document.outputFormat();
  const bool isGltf = own == "glb" || own == "gltf";
  return own != format && !document.canWriteAs(format) &&
         (format == "glb" || (format == "gltf" && !isGltf) || (format == "obj" && isGltf));
}

Result<FileSet> convertFiles(const Document& document, const FileSet& files,
                             std::string_view format, int surface, const Limits& limits) {
  FileSet out;
  out.name = files.name;
  out.notes = files.notes;
  out.decoders = files.decoders;
  if (format == "glb" && std::string_view(document.format()) == "gltf") {
    auto packed = gltfAsGlb(files, limits, out.notes);
    if (!packed) return packed.error();
    out.main = std::move(*packed);
    return out;
  }
  auto plain = document.plain(surface);
  if (!plain) return plain.error();
  for (const Surface& from : document.surfaces())
    out.notes.insert(out.notes.end(), from.notes.begin(), from.notes.end());
  for (Note& lost : plain->lost) {
    lost.values.push_back({"from", document.format()});
    lost.values.push_back({"to", std::string(format)});
    out.notes.push_back(std::move(lost));
  }
  out.main = format == "obj" ? plainObj(*plain, "") : plainGlb(*plain, "hgp");
  return out;
}

}  // namespace hgp::io
