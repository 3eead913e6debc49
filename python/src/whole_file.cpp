#include "hgp/api/whole_file.h"

#include <pybind11/stl.h>

#include <utility>

#include "../../examples/cli/files.h"
#include "../../examples/cli/mesh_notes.h"
#include "failures.h"
#include "hgp/base/phrase.h"
#include "options.h"
#include "surface.h"
#include "watch.h"
#include "writing.h"

namespace hgp::python {
namespace {

/// What can be refused before anything is solved.
Status possible(const api::Session& session, const api::SolveOptions& solve,
                const Writing& writing) {
  if (solve.refines && session.surfaceCount() > 1)
    return Failure{ErrorCode::kUsage,
                   "refine",
                   "refine is for one mesh and the file has several: load one with Mesh.load",
                   {}};
  if (Status can = session.canWrite(writing.after.output); !can) return can;
  return cli::checkWritable(writing.after.output);
}

py::dict toPython(api::FileOutcome outcome, const std::vector<std::string>& notes) {
  py::list meshes;
  for (api::MeshOutcome& one : outcome.meshes) {
    const py::object error = one.failure ? errorOf(*one.failure) : py::object(py::none());
    meshes.append(
        py::make_tuple(one.mesh, one.isCertified, one.isAligned, std::move(one.report), error));
  }
  py::dict out;
  out["meshes"] = meshes;
  out["notes"] = notes;
  out["is_written"] = outcome.written.has_value();
  return out;
}

}  // namespace

py::dict Surface::parametrizeFile(const py::dict& asked, const py::dict& options,
                                  const std::string& path, const py::dict& saving,
                                  bool isReproducible, std::optional<double> limit,
                                  const py::object& progress) {
  Watch watch(progress, limit);
  Writing writing = toWriting(*source_, path, saving);
  api::WholeFileOptions how;
  how.solve = toSolveOptions(options);
  how.solve.progress = watch.progress();
  how.q = orderOf(asked);
  how.ignoresEmbedded = isSet(asked, "ignore_embedded");
  how.features = toFeatures(asked);
  how.onMesh = [&watch](int mesh) { watch.begin(mesh); };
  Arithmetic::check(isReproducible);
  std::vector<std::string> notes;
  Result<api::FileOutcome> made = alone_.run([&]() -> Result<api::FileOutcome> {
    if (Status done = ready(); !done) return done.error();
    if (Status can = possible(session_, how.solve, writing); !can) return can.error();
    const Arithmetic arithmetic(isReproducible);
    how.write = writing.core;
    how.write.name = nameOfWhole(session_, writing);
    Result<api::FileOutcome> outcome = api::parametrizeFile(session_, how);
    session_ = api::Session();
    isLoaded_ = false;
    if (!outcome || !outcome->written) return outcome;
    cli::MeshNotes ofMeshes;
    for (std::size_t i = 0; i < outcome->inFile.size(); ++i)
      for (const Note& note : outcome->written->mapNotes[i])
        ofMeshes.add(outcome->inFile[i], note.code, phrase(note));
    notes = ofMeshes.lines();
    Notes ofFile = std::move(outcome->written->notes);
    if (Status done = finishAndWrite(outcome->written->files, ofFile, *source_, writing); !done)
      return done.error();
    for (const Note& note : ofFile) notes.push_back(phrase(note));
    return outcome;
  });
  if (!made) watch.raise(made.error());
  return toPython(std::move(*made), notes);
}

}  // namespace hgp::python
