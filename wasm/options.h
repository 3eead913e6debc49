// Files, prescriptions and options of JavaScript for the core.  Role: options are objects as JSON, read by the core's table.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>

#include "convert.h"
#include "hgp/api/options_from_json.h"

namespace hgp::js {

/// The main file and its side files, all of which are passed in advance: nothing is fetched.
inline io::FileSet toFileSet(const std::string& main, const val& names, const val& contents) {
  std::map<std::string, io::Bytes> files;
  const std::vector<std::string> keys = toStrings(names);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    files[keys[i]] = toVector<std::uint8_t>(contents[i]);
  }
  io::FileSet set;
  set.name = main;
  set.main = std::move(files[main]);
  set.resolve = [files = std::move(files)](const std::string& name) -> Result<io::Bytes> {
    const auto found = files.find(name);
    if (found != files.end()) return found->second;
    return Failure{ErrorCode::kMalformed, "read", name + " is missing.", {}};
  };
  return set;
}

/// The options of a call to solve, with its progress.
inline Result<api::SolveOptions> toSolveOptions(const std::string& options, const val& onProgress) {
  auto made = api::optionsFromJson<api::SolveOptions>(options);
  if (made) made->progress = toProgress(onProgress);
  return made;
}

using MaybePrescription = Result<std::optional<prescription::Prescription>>;

/// The text of a cone file, or "" for none, with the field file files.field = {name, text, q} and the list of features
/// files.features = {name, text}, where they are there.
inline MaybePrescription toPrescription(const std::string& cones, const val& files) {
  std::optional<prescription::Prescription> asked;
  if (!cones.empty()) {
    auto read = api::readPrescription("cones.json", cones, 0);
    if (!read) return MaybePrescription(read.error());
    asked = std::move(*read);
  }
  const val file = files["field"], list = files["features"];
  if (!file.isUndefined()) {
    auto field = api::readPrescription(file["name"].as<std::string>(),
                                       file["text"].as<std::string>(), file["q"].as<int>());
    if (field && asked) field = api::withField(std::move(*asked), std::move(*field));
    if (!field) return MaybePrescription(field.error());
    asked = std::move(*field);
  }
  if (!list.isUndefined()) {
    auto features =
        api::readFeatures(list["name"].as<std::string>(), list["text"].as<std::string>());
    if (!features) return MaybePrescription(features.error());
    if (!asked) asked.emplace();
    asked->features = std::move(*features);
  }
  return MaybePrescription(std::move(asked));
}

}  // namespace hgp::js
