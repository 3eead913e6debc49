#include "writing.h"

#include <mutex>

#include "../../examples/cli/files.h"
#include "../../examples/cli/half_file.h"
#include "../../examples/cli/side_files.h"
#include "failures.h"
#include "options.h"

namespace hgp::python {

Writing toWriting(const Source& source, const std::string& path, const py::dict& options) {
  Writing out;
  out.after.input = source.path;
  out.after.output = path;
  out.after.load = source.options;
  out.after.isEmbedded = isSet(options, "embed");
  out.after.isCompressed = isSet(options, "compress");
  out.after.mayOverwrite = isSet(options, "overwrite");
  py::dict core;
  for (const auto& [name, value] : options) core[name] = value;
  for (const char* name : {"embed", "compress", "overwrite"}) core.attr("pop")(name, py::none());
  out.core = toWriteOptions(core);
  out.core.name = path;
  out.core.isSideFileNoted = false;
  out.core.isCompressedLater = out.after.isCompressed;
  if (!out.after.mayOverwrite && cli::isSameFile(path, source.path))
    raiseUsage(path + " is the file that was loaded; overwrite=True allows to replace it");
  return out;
}

std::string nameOfWhole(const api::Session& session, const Writing& writing) {
  const bool isGlb = session.canWrite("x.glb").hasValue();
  return isGlb && writing.after.load.target == "gltf" ? "mesh.glb" : writing.after.output;
}

Status finishAndWrite(std::vector<io::OutputFile>& files, Notes& notes, const Source& source,
                      const Writing& writing) {
  Status finished = cli::finishFiles(files, notes, source.files.resolve, writing.after);
  return finished ? writeTogether(writing.after.output, files) : finished;
}

Status writeTogether(const std::string& path, const std::vector<io::OutputFile>& files) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  Status done = cli::writeFiles(path, files);
  if (!done) cli::HalfFile::forgetAll();
  return done;
}

}  // namespace hgp::python
