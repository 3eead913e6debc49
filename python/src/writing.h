// How maps become files.  Role: what Map.save, combine and parametrize_file share.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

#include "../../examples/cli/arguments.h"
#include "hgp/api/session.h"
#include "surface.h"

namespace hgp::python {

/// The options of Map.save: what the core does, and what happens after it has written.
struct Writing {
  api::WriteOptions core;
  cli::Arguments after;
};

/// Raises UsageError if `path` is the file that was loaded and may not be replaced.
Writing toWriting(const Source& source, const std::string& path, const py::dict& options);

/// The name under which FileMaps writes: a GLB that becomes a .gltf stays one until all maps are in it.
std::string nameOfWhole(const api::Session& session, const Writing& writing);

/// Adds the side files and writes all. @param notes  of these steps, for users
Status finishAndWrite(std::vector<io::OutputFile>& files, Notes& notes, const Source& source,
                      const Writing& writing);

/// Writes files, one result at a time: the names of half-written files are those of the whole process.
Status writeTogether(const std::string& path, const std::vector<io::OutputFile>& files);

}  // namespace hgp::python
