#include <pybind11/stl.h>

#include <algorithm>
#include <mutex>
#include <utility>

#include "../../examples/cli/also.h"
#include "../../examples/cli/files.h"
#include "../../examples/cli/half_file.h"
#include "../../examples/cli/side_files.h"
#include "failures.h"
#include "hgp/base/phrase.h"
#include "options.h"
#include "surface.h"

namespace hgp::python {
namespace {

/// Writes files, one result at a time: the names of half-written files are those of the whole process.
Status writeTogether(const std::string& path, const std::vector<io::OutputFile>& files) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  Status done = cli::writeFiles(path, files);
  if (!done) cli::HalfFile::forgetAll();
  return done;
}

/// How the command line writes such a file: with -o if the loaded file can be written under this name, else with --also.
api::MapFormat formatFor(const api::Session& session, const std::string& path) {
  const auto plain = cli::alsoFormat(path);
  const bool isDrawing = plain == api::MapFormat::kFlatObj || plain == api::MapFormat::kSvg;
  if (!isDrawing && session.canWrite(path)) return api::MapFormat::kSame;
  return plain.value_or(api::MapFormat::kSame);
}

}  // namespace

py::dict Map::measure() {
  api::MapMeasures made = must(alone_.run([&] { return session_.measure(); }));
  py::dict out;
  out["stretch"] = taken<float>(std::move(made.stretch));
  out["log_area"] = taken<float>(std::move(made.logArea));
  out["not_positive"] = taken<std::int32_t>(std::move(made.notPositive));
  out["surface_area"] = made.surfaceArea;
  out["uv_area"] = made.uvArea;
  out["overlap_pairs"] = made.overlapPairs;
  out["overlapping"] = taken<std::int32_t>(std::move(made.overlapping));
  out["more_overlaps"] = made.areMorePairs;
  out["seam_chain"] = taken<std::int32_t>(std::move(made.seamChain));
  return out;
}

py::dict Map::quads() {
  const api::QuadFile made = must(alone_.run([&] { return session_.quads("quads.obj"); }));
  py::dict out;
  out["obj"] = py::bytes(reinterpret_cast<const char*>(made.bytes.data()), made.bytes.size());
  out["clipped"] = made.clipped;
  out["cuts"] = made.cuts;
  out["replaced"] = made.replaced;
  out["halvings"] = made.halvings;
  out["folded_in_space"] = made.foldedInSpace;
  out["multiple_edges"] = made.multipleEdges;
  out["folded"] = made.foldedQuads;
  return out;
}

void Map::saveQuads(const std::string& path) {
  must(alone_.run([&]() -> Status {
    Result<api::QuadFile> made = session_.quads(path);
    if (!made) return made.error();
    return writeTogether(path, {{path, std::move(made->bytes)}});
  }));
}

std::vector<std::string> Map::save(const std::string& path, const py::dict& options) {
  cli::Arguments asked;
  asked.input = source_->path;
  asked.output = path;
  asked.load = source_->options;
  asked.isEmbedded = isSet(options, "embed");
  asked.isCompressed = isSet(options, "compress");
  asked.mayOverwrite = isSet(options, "overwrite");
  py::dict core;  // without what happens after the core has written
  for (const auto& [name, value] : options) core[name] = value;
  for (const char* name : {"embed", "compress", "overwrite"}) core.attr("pop")(name, py::none());
  api::WriteOptions how = toWriteOptions(core);
  how.name = path;
  how.isSideFileNoted = false;
  how.isCompressedLater = asked.isCompressed;
  if (!asked.mayOverwrite && cli::isSameFile(path, source_->path))
    raiseUsage(path + " is the file that was loaded; overwrite=True allows to replace it");
  Notes notes;
  must(alone_.run([&]() -> Status {
    how.format = formatFor(session_, path);
    Result<api::WrittenMap> written = session_.write(how);
    if (!written) return written.error();
    notes = std::move(written->notes);
    const bool isSame = how.format == api::MapFormat::kSame;
    if (isSame) {
      Status finished = cli::finishFiles(written->files, notes, source_->files.resolve, asked);
      if (!finished) return finished;
    }
    return writeTogether(path, written->files);
  }));
  std::vector<std::string> sentences;
  for (const Note& note : notes) sentences.push_back(phrase(note));
  return sentences;
}

}  // namespace hgp::python
