#include "hgp/api/session/side_files.h"

#include <algorithm>
#include <string_view>

#include "hgp/api/session/guard.h"
#include "hgp/io/gltf/pack/compress.h"
#include "hgp/io/gltf/pack/encoders.h"
#include "hgp/io/gltf/pack/pack.h"

namespace hgp::api {
namespace {

const io::OutputFile* findFile(const std::vector<io::OutputFile>& files, const std::string& name) {
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].name == name) return &files[i];
  return nullptr;
}

bool isGlb(io::ByteView bytes) {
  return bytes.size() >= 4 && std::string_view(reinterpret_cast<const char*>(bytes.data()), 4) ==
                                  std::string_view("glTF");
}

/// Whether the main file is glTF, by its first significant byte: texts of other formats begin differently.
bool isGltf(const std::vector<io::OutputFile>& files) {
  if (files.empty()) return false;
  const io::Bytes& bytes = files[0].bytes;
  if (isGlb(bytes)) return true;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              std::min<std::size_t>(bytes.size(), 4096));
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string_view::npos && text[first] == '{';
}

/// The rest of every line of a text that begins with this keyword ("map_": with any word that begins so), once each.
std::vector<std::string> namesAfter(io::ByteView bytes, std::string_view keyword) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::vector<std::string> out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::string_view line = text.substr(begin, end - begin);
    begin = end + 1;
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    if (line.substr(0, keyword.size()) != keyword) continue;
    line.remove_prefix(std::min(line.find_first_of(" \t"), line.size()));
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    std::string name(line.substr(0, line.find_last_not_of(" \t\r") + 1));
    std::replace(name.begin(), name.end(), '\\', '/');
    if (!name.empty() && std::find(out.begin(), out.end(), name) == out.end())
      out.push_back(std::move(name));
  }
  return out;
}

}  // namespace

std::vector<std::string> missingSideFiles(const std::vector<io::OutputFile>& files,
                                          std::vector<std::string>* refused) {
  std::vector<std::string> out;
  if (files.empty()) return out;
  std::vector<std::string> names = isGltf(files) ? io::gltfSideFiles(files[0].bytes, refused)
                                                 : namesAfter(files[0].bytes, "mtllib");
  for (std::string& name : names)
    if (findFile(files, name) == nullptr) out.push_back(std::move(name));
  return out;
}

std::vector<std::string> picturesOfMaterials(io::ByteView library) {
  std::vector<std::string> out;
  for (const std::string& rest : namesAfter(library, "map_")) {
    const std::size_t last = rest.find_last_of(" \t");  // options come before the name
    out.push_back(last == std::string::npos ? rest : rest.substr(last + 1));
  }
  return out;
}

Result<io::Written> withEmbedded(std::vector<io::OutputFile> files, const io::Resolver& resolve,
                                 const io::Limits& limits) {
  return guarded([&]() -> Result<io::Written> {
    io::Written out;
    if (files.empty() || io::gltfSideFiles(files[0].bytes).empty()) {
      out.files = std::move(files);
      return out;
    }
    const io::Resolver either = [&](const std::string& name) -> Result<io::Bytes> {
      if (const io::OutputFile* made = findFile(files, name)) return made->bytes;
      if (resolve) return resolve(name);
      return Failure{ErrorCode::kMalformed, "read", name + " is missing", {}};
    };
    auto main = io::gltfWithEmbedded(files[0].bytes, either, limits, out.notes);
    if (!main) return main.error();
    out.files.push_back({files[0].name, std::move(*main)});
    return out;
  });
}

Result<io::Written> compressed(const std::vector<io::OutputFile>& files,
                               const io::Resolver& resolve, const io::Limits& limits) {
  return guarded([&]() -> Result<io::Written> {
    if (!isGltf(files))
      return Failure{ErrorCode::kUsage, "write", "only glTF and GLB can be compressed", {}};
    return io::compressGltf(files, resolve, limits);
  });
}

bool canCompress() { return io::canPackViews(); }
Status canCompress(io::ByteView main) {
  return guarded([&] { return io::canCompressGltf(main); });
}

Result<io::Written> asGltf(std::vector<io::OutputFile> files, const std::string& name) {
  return guarded([&]() -> Result<io::Written> {
    if (isGltf(files) && isGlb(files[0].bytes)) return io::glbAsGltf(files[0].bytes, name);
    io::Written out;
    out.files = std::move(files);
    return out;
  });
}

}  // namespace hgp::api
