// Converts plain objects of JavaScript to options of the core. Names are the same on both sides.
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "convert.h"

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

inline api::LoadOptions toLoadOptions(const val& options) {
  api::LoadOptions o;
  o.surface = option(options, "surface", o.surface);
  o.weld = option(options, "weld", o.weld);
  // If repairs are named, even none of them, exactly those are made.
  const val fix = option(options, "fix", val::object());
  o.isStrict = option(options, "strict", !option(options, "fix", val::undefined()).isUndefined());
  o.writesRepairs = option(options, "writeRepairs", o.writesRepairs);
  o.target = option(options, "target", o.target);
  o.fix.orient = option(fix, "orient", false);
  o.fix.split = option(fix, "split", false);
  o.fix.degenerate = option(fix, "degenerate", false);
  const val limits = option(options, "limits", val::object());
  const auto limit = [&](const char* name, std::uint64_t otherwise) {
    return static_cast<std::uint64_t>(option(limits, name, static_cast<double>(otherwise)));
  };
  o.limits.maxBytes = limit("bytes", o.limits.maxBytes);
  o.limits.maxTriangles = limit("triangles", o.limits.maxTriangles);
  return o;
}

/// A word or a number; anything else becomes a balance that the core refuses.
inline ImproveOptions toImproveOptions(const val& word) {
  ImproveOptions improve;
  if (word.isNumber())
    improve.balance = word.as<double>();
  else if (word.isString())
    improve.balance = api::improveBalance(word.as<std::string>()).value_or(std::nan(""));
  else
    improve.balance = std::nan("");
  return improve;
}

inline api::SolveOptions toSolveOptions(const val& options, const val& onProgress) {
  api::SolveOptions o;
  o.q = option(options, "q", o.q);
  o.coneCount = option(options, "count", o.coneCount);
  const auto conesFor = conesForNamed(option(options, "conesFor", std::string("balanced")));
  if (conesFor) o.conesFor = *conesFor;
  o.alignToCurvature = option(options, "alignToCurvature", o.alignToCurvature);
  const auto boundary = option(options, "boundary", std::string("free"));
  if (boundary == "convex") o.boundary = api::BoundaryKind::kConvex;
  o.maxRounds = option(options, "maxRounds", o.maxRounds);
  const auto method = option(options, "method", std::string("auto"));
  o.method = methodNamed(method).value_or(Method::kAuto);
  if (option(options, "quality", false)) o.improve.emplace();
  o.keepsGoing = option(options, "keepGoing", o.keepsGoing);
  const val improve = option(options, "improve", val::undefined());
  if (!improve.isUndefined() && !improve.isNull()) o.improve = toImproveOptions(improve);
  const auto frames = option(options, "frames", std::string("auto"));
  if (frames == "file") o.frames = api::FrameSource::kFile;
  const auto scale = option(options, "scale", std::string("solved"));
  if (scale == "unit") o.scale = api::Scale::kUnit;
  if (scale == "fit") o.scale = api::Scale::kFit;
  o.refines = option(options, "refine", false);
  o.convexPolygons = option(options, "convexPolygons", false);
  const val grid = option(options, "grid", val::object());
  o.grid.cells = option(grid, "cells", 0.0);
  o.grid.spacing = option(grid, "spacing", 0.0);
  const std::string mode = option(grid, "mode", std::string());
  if (mode == "quad") o.grid.mode = GridMode::kQuad;
  o.choosesCells = !mode.empty() && !o.grid.isAsked();
  o.progress = toProgress(onProgress);
  return o;
}

inline api::VerifyOptions toVerifyOptions(const val& options) {
  api::VerifyOptions o;
  o.q = option(options, "q", o.q);
  o.uvSet = option(options, "uvSet", o.uvSet);
  o.tolerance = option(options, "tolerance", o.tolerance);
  return o;
}

inline api::WriteOptions toWriteOptions(const val& options) {
  api::WriteOptions o;
  o.uvSet = option(options, "uvSet", o.uvSet);
  o.name = option(options, "name", o.name);
  o.format = api::mapFormatNamed(option(options, "format", std::string("same"))).value_or(o.format);
  const val grid = option(options, "gridMaterial", val(false));
  if (grid.isNumber())
    o.gridTiles = grid.as<double>();
  else if (grid.isTrue())
    o.gridTiles = 0.0;
  o.embedCones = option(options, "embedCones", o.embedCones);
  o.allowUncertified = option(options, "allowUncertified", o.allowUncertified);
  o.pointsMaterials = option(options, "use", o.pointsMaterials);
  return o;
}

using MaybePrescription = Result<std::optional<io::Prescription>>;

/// The text of a cone file, or "" for none, with the field file options.field = {name, text}.
inline MaybePrescription toPrescription(const std::string& cones, const val& options) {
  std::optional<io::Prescription> asked;
  if (!cones.empty()) {
    auto read = api::readPrescription("cones.json", cones, 0);
    if (!read) return MaybePrescription(read.error());
    asked = std::move(*read);
  }
  const val file = option(options, "field", val::undefined());
  if (!file.isUndefined()) {
    auto field = api::readPrescription(file["name"].as<std::string>(),
                                       file["text"].as<std::string>(), option(file, "q", 0));
    if (field && asked) field = api::withField(std::move(*asked), std::move(*field));
    if (!field) return MaybePrescription(field.error());
    asked = std::move(*field);
  }
  return MaybePrescription(std::move(asked));
}

}  // namespace hgp::js
