#include "side_files.h"

#include <algorithm>
#include <filesystem>

#include "files.h"
#include "hgp/api/session/side_files.h"
#include "hgp/base/check.h"

namespace hgp::cli {
namespace {

Status take(Result<io::Written> made, std::vector<io::OutputFile>& files,
            std::vector<std::string>& notes) {
  if (!made) return made.error();
  files = std::move(made->files);
  notes.insert(notes.end(), made->notes.begin(), made->notes.end());
  return Done{};
}

/// Adds missing side files: images of a glTF, whose buffers have been read; materials of an OBJ and their pictures.
Status addSideFiles(std::vector<io::OutputFile>& files, std::vector<std::string>& notes,
                    const io::Resolver& resolve, const Arguments& asked) {
  if (asked.isEmbedded)
    return take(api::withEmbedded(std::move(files), resolve, asked.load.limits), files, notes);
  const std::string to = folderOf(asked.output);
  if (asked.output == "-" || to == folderOf(asked.input)) return Done{};
  std::vector<std::string> refused;
  std::vector<std::string> missing = api::missingSideFiles(files, &refused);
  for (const std::string& why : refused)
    notes.push_back(why + "; it is not copied, and the reference to it is kept");
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const std::string name = missing[i];
    Result<io::Bytes> bytes = resolve ? resolve(name) : Result<io::Bytes>(io::Bytes());
    if (!bytes && bytes.error().code == ErrorCode::kMalformed) {
      notes.push_back(bytes.error().message + "; the reference to it is kept");
      continue;
    }
    if (!bytes) return bytes.error();
    if (name.size() > 4 && name.substr(name.size() - 4) == ".mtl")
      for (std::string& picture : api::picturesOfMaterials(*bytes))
        if (std::find(missing.begin(), missing.end(), picture) == missing.end())
          missing.push_back(std::move(picture));
    const std::string place = (std::filesystem::path(to) / name).string();
    if (std::filesystem::exists(place)) {
      const Result<io::Bytes> there = readFile(place, asked.load.limits.maxBytes);
      if (there && *there == *bytes) continue;
      if (!asked.mayOverwrite) {
        return Failure{ErrorCode::kUsage,
                       "write",
                       place +
                           " is another file than the one the input needs; --force replaces it, "
                           "--embed needs none",
                       {}};
      }
    }
    files.push_back({name, std::move(*bytes)});
  }
  return Done{};
}

}  // namespace

Status finishFiles(std::vector<io::OutputFile>& files, std::vector<std::string>& notes,
                   const io::Resolver& resolve, const Arguments& asked) {
  if (asked.load.target == "gltf") {
    const Status done = take(api::asGltf(std::move(files), asked.output), files, notes);
    if (!done) return done;
  }
  if (asked.isCompressed) {
    const Status done = take(api::compressed(files, resolve, asked.load.limits), files, notes);
    if (!done) return done;
  }
  return addSideFiles(files, notes, resolve, asked);
}

}  // namespace hgp::cli
