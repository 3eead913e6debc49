#include <pybind11/stl.h>

#include <utility>

#include "../../examples/cli/also.h"
#include "../../examples/cli/files.h"
#include "../../examples/cli/quad_files.h"
#include "failures.h"
#include "hgp/api/file_maps.h"
#include "hgp/base/phrase.h"
#include "surface.h"
#include "writing.h"

namespace hgp::python {
namespace {

/// How the command line writes such a file: with -o if the loaded file can be written under this name, else with --also.
api::MapFormat formatFor(const api::Session& session, const std::string& path) {
  const auto plain = cli::alsoFormat(path);
  const bool isDrawing = plain == api::MapFormat::kFlatObj || plain == api::MapFormat::kSvg;
  if (!isDrawing && session.canWrite(path)) return api::MapFormat::kSame;
  return plain.value_or(api::MapFormat::kSame);
}

/// Whether both are the same file with the same bytes, converted alike.
bool isSameReading(const Source& a, const Source& b) {
  return cli::isSameFile(a.path, b.path) && a.options.target == b.options.target &&
         a.files.main == b.files.main;
}

std::vector<std::string> phrases(const Notes& notes) {
  std::vector<std::string> sentences;
  for (const Note& note : notes) sentences.push_back(phrase(note));
  return sentences;
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
  out["across_seams"] = made.acrossSeams;
  return out;
}

std::vector<std::string> Map::saveQuads(const std::string& path, const py::dict& options) {
  const Writing writing = toWriting(*source_, path, options);
  const std::string beside = cli::objBeside(path);
  if (!beside.empty() && cli::isSameFile(beside, source_->path))
    raiseUsage(beside + ", which is written beside " + path +
               ", is the file that was loaded; choose another name");
  Notes notes;
  must(alone_.run([&]() -> Status {
    Result<cli::QuadFiles> made =
        cli::makeQuadFiles(session_, source_->files.resolve, writing.after);
    if (!made) return made.error();
    notes = std::move(made->quads.notes);
    return writeTogether(path, made->files);
  }));
  return phrases(notes);
}

std::vector<std::string> Map::save(const std::string& path, const py::dict& options) {
  Writing writing = toWriting(*source_, path, options);
  Notes notes;
  must(alone_.run([&]() -> Status {
    writing.core.format = formatFor(session_, path);
    Result<api::WrittenMap> written = session_.write(writing.core);
    if (!written) return written.error();
    notes = std::move(written->notes);
    const bool isSame = writing.core.format == api::MapFormat::kSame;
    return isSame ? finishAndWrite(written->files, notes, *source_, writing)
                  : writeTogether(path, written->files);
  }));
  return phrases(notes);
}

std::vector<std::string> Map::saveAll(const std::vector<std::shared_ptr<Map>>& maps,
                                      const std::string& path, const py::dict& options) {
  if (maps.empty()) raiseUsage("there are no maps");
  if (maps.size() == 1) return maps[0]->save(path, options);
  const Source& source = *maps[0]->source_;
  for (const std::shared_ptr<Map>& map : maps)
    if (!isSameReading(*map->source_, source))
      raiseUsage("the maps are not all of meshes of one file");
  Writing writing = toWriting(source, path, options);
  must(maps[0]->session_.canWrite(path));
  writing.core.name = nameOfWhole(maps[0]->session_, writing);
  api::FileMaps whole(writing.core);
  for (const std::shared_ptr<Map>& map : maps)
    must(map->alone_.run([&] { return whole.add(map->session_); }));
  Notes notes;
  must([&]() -> Status {
    const py::gil_scoped_release release;
    Result<api::WrittenFile> written = whole.write();
    if (!written) return written.error();
    for (const Notes& own : written->mapNotes) notes.insert(notes.end(), own.begin(), own.end());
    notes.insert(notes.end(), written->notes.begin(), written->notes.end());
    return finishAndWrite(written->files, notes, source, writing);
  }());
  return phrases(notes);
}

}  // namespace hgp::python
