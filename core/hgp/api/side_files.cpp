#include "hgp/api/side_files.h"

#include "hgp/api/guard.h"
#include "hgp/io/gltf/gltf_pack.h"

namespace hgp::api {
namespace {

const io::OutputFile* findFile(const std::vector<io::OutputFile>& files, const std::string& name) {
  for (std::size_t i = 1; i < files.size(); ++i)
    if (files[i].name == name) return &files[i];
  return nullptr;
}

}  // namespace

std::vector<std::string> missingSideFiles(const std::vector<io::OutputFile>& files) {
  std::vector<std::string> out;
  if (files.empty()) return out;
  for (std::string& name : io::gltfSideFiles(files[0].bytes))
    if (findFile(files, name) == nullptr) out.push_back(std::move(name));
  return out;
}

Result<std::vector<io::OutputFile>> withEmbedded(std::vector<io::OutputFile> files,
                                                 const io::Resolver& resolve,
                                                 const io::Limits& limits) {
  return guarded([&]() -> Result<std::vector<io::OutputFile>> {
    if (files.empty() || io::gltfSideFiles(files[0].bytes).empty()) return std::move(files);
    const io::Resolver either = [&](const std::string& name) -> Result<io::Bytes> {
      if (const io::OutputFile* made = findFile(files, name)) return made->bytes;
      if (resolve) return resolve(name);
      return Failure{ErrorCode::kMalformed, "read", name + " is missing", {}};
    };
    auto main = io::gltfWithEmbedded(files[0].bytes, either, limits);
    if (!main) return main.error();
    std::vector<io::OutputFile> out;
    out.push_back({files[0].name, std::move(*main)});
    return out;
  });
}

}  // namespace hgp::api
