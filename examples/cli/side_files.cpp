#include "side_files.h"

#include <algorithm>
#include <filesystem>

#include "files.h"
#include "hgp/api/session/side_files.h"
#include "hgp/base/check.h"

namespace hgp::cli {
namespace {

Status take(Result<io::Written> made, std::vector<io::OutputFile>& files, Notes& notes) {
  if (!made) return made.error();
  files = std::move(made->files);
  addNotes(notes, std::move(made->notes));
  return Done{};
}

/// Where a side file will be, if another file of that name is already there and may not be replaced.
Status refuseOther(const std::string& place, const io::Bytes& bytes, const Arguments& asked,
                   bool& isThere) {
  const Result<io::Bytes> there = readFile(place, asked.load.limits.maxBytes);
  isThere = there && *there == bytes;
  if (isThere || asked.mayOverwrite) return Done{};
  return Failure{ErrorCode::kUsage,
                 "write",
                 place +
                     " is another file than the one the input needs; --force replaces it, "
                     "--embed needs none",
                 {}};
}

/// Adds missing side files: images of a glTF, whose buffers have been read; materials of an OBJ and their pictures.
/// @param isOnlyChecked  what may be added is looked at and not added
Status addSideFiles(std::vector<io::OutputFile>& files, Notes& notes, const io::Resolver& resolve,
                    const Arguments& asked, bool isOnlyChecked) {
  const std::string to = folderOf(asked.output);
  if (asked.output == "-" || to == folderOf(asked.input)) return Done{};
  std::vector<std::string> refused;
  std::vector<std::string> missing = api::missingSideFiles(files, &refused);
  for (const std::string& why : refused)
    notes.push_back(Note("write-file-refused", {{"why", why}}));
  for (std::size_t i = 0; i < missing.size(); ++i) {
    const std::string name = missing[i];
    const bool isLibrary = name.size() > 4 && name.substr(name.size() - 4) == ".mtl";
    const std::string place = (std::filesystem::path(to) / name).string();
    bool isThere = std::filesystem::exists(place);
    if (isOnlyChecked && !isLibrary && !isThere) continue;
    Result<io::Bytes> bytes = resolve ? resolve(name) : Result<io::Bytes>(io::Bytes());
    if (!bytes && bytes.error().code == ErrorCode::kMalformed) {
      const Note refusal("read-file-refused", {{"why", bytes.error().message}});
      if (std::find(notes.begin(), notes.end(), refusal) == notes.end()) notes.push_back(refusal);
      continue;
    }
    if (!bytes) return bytes.error();
    if (isLibrary)
      for (std::string& picture : api::picturesOfMaterials(*bytes))
        if (std::find(missing.begin(), missing.end(), picture) == missing.end())
          missing.push_back(std::move(picture));
    if (isThere) {
      if (Status done = refuseOther(place, *bytes, asked, isThere); !done) return done;
    }
    if (!isThere && !isOnlyChecked) files.push_back({name, std::move(*bytes)});
  }
  return checkFileCount(files.size() + (isOnlyChecked ? missing.size() : 0));
}

}  // namespace

Status finishFiles(std::vector<io::OutputFile>& files, Notes& notes, const io::Resolver& resolve,
                   const Arguments& asked) {
  if (asked.load.target == "gltf") {
    const Status done = take(api::asGltf(std::move(files), asked.output), files, notes);
    if (!done) return done;
  }
  if (asked.isCompressed) {
    const Status done = take(api::compressed(files, resolve, asked.load.limits), files, notes);
    if (!done) return done;
  }
  if (asked.isEmbedded)
    return take(api::withEmbedded(std::move(files), resolve, asked.load.limits), files, notes);
  return addSideFiles(files, notes, resolve, asked, false);
}

Status checkSideFiles(io::FileSet& input, const Arguments& asked) {
  const bool isGltf = asked.load.target == "glb" || asked.load.target == "gltf";
  if (isGltf && asked.isCompressed) {
    if (Status possible = api::canCompress(input.main); !possible) return possible;
  }
  const bool isText = !input.main.empty() && input.main[0] != 'g' && input.main[0] != '{';
  if (asked.isEmbedded || isGltf == isText) return Done{};  // or another format, without side files
  Notes notes;
  std::vector<io::OutputFile> files;
  files.push_back({asked.output, std::move(input.main)});
  Status done = addSideFiles(files, notes, input.resolve, asked, true);
  input.main = std::move(files[0].bytes);
  return done;
}

}  // namespace hgp::cli
