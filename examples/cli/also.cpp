#include "also.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "files.h"
#include "hgp/base/check.h"
#include "hgp/base/phrase.h"

namespace hgp::cli {
namespace {

constexpr std::array<std::pair<std::string_view, api::MapFormat>, 5> kEndings{
    {{".flat.obj", api::MapFormat::kFlatObj},
     {".obj", api::MapFormat::kObj},
     {".glb", api::MapFormat::kGlb},
     {".gltf", api::MapFormat::kGltf},
     {".svg", api::MapFormat::kSvg}}};

bool endsWith(const std::string& name, std::string_view ending) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return name.size() > ending.size() && std::equal(ending.rbegin(), ending.rend(), name.rbegin(),
                                                   [&](char a, char b) { return a == lower(b); });
}

}  // namespace

std::optional<api::MapFormat> alsoFormat(const std::string& name) {
  for (const auto& [ending, format] : kEndings)
    if (endsWith(name, ending)) return format;
  return std::nullopt;
}

Result<std::vector<AlsoFile>> makeAlso(const api::Session& session, const Arguments& asked) {
  std::vector<AlsoFile> out;
  out.reserve(asked.also.size());
  for (const std::string& path : asked.also) {
    api::WriteOptions options = asked.write;
    options.format = alsoFormat(path).value_or(api::MapFormat::kObj);
    options.name = path;
    options.allowUncertified = options.allowUncertified || asked.solve.keepsGoing;
    Result<api::WrittenMap> written = session.write(options);
    if (!written) {
      Failure failure = written.error();
      failure.message = path + ": " + failure.message;
      return failure;
    }
    out.push_back({path, std::move(*written)});
  }
  return out;
}

Status writeFaces(const api::Session& session, const std::string& path) {
  const Result<api::MapMeasures> made = session.measure();
  if (!made) return made.error();
  std::string text = "triangle,stretch,log2_area,overlaps\n";
  auto overlapping = made->overlapping.begin();
  for (std::size_t t = 0; t < made->stretch.size(); ++t) {
    const bool isIn = overlapping != made->overlapping.end() && *overlapping == static_cast<int>(t);
    if (isIn) ++overlapping;
    text += formatText("%zu,%.7g,%.7g,%d\n", t, static_cast<double>(made->stretch[t]),
                       static_cast<double>(made->logArea[t]), isIn ? 1 : 0);
  }
  return writeText(path, text);
}

Status writeLoops(const api::Session& session, const std::string& path) {
  const Result<api::SurfaceLoops> loops = session.loops();
  if (!loops) return loops.error();
  const nlohmann::ordered_json json{{"boundaries", loops->boundaries}, {"handles", loops->handles}};
  return writeText(path, json.dump() + "\n");
}

Status writeAlso(const std::vector<AlsoFile>& files, std::vector<std::string>& lines) {
  for (const AlsoFile& file : files) {
    if (Status done = writeFiles(file.path, file.written.files); !done) return done;
    for (const Note& note : file.written.notes) lines.push_back(file.path + ": " + phrase(note));
    lines.push_back("also wrote " + file.path +
                    (file.written.isCertified ? "" : ", which is not certified"));
  }
  return Done{};
}

}  // namespace hgp::cli
