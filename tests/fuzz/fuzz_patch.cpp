// Whatever can be read can be written, and comes back with the new uv and the same surface.
#include "fuzz_support.h"
#include "glb_mutator.h"
#include "hgp/io/gltf/json/json.h"

using namespace hgp;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  return fuzz::mutateGlb(data, size, maxSize, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const io::Limits limits = fuzz::smallLimits();
  const auto document = io::readGltf(fuzz::fileSet("a.glb", data, size), limits);
  if (!document) return 0;
  const io::Surface& surface = (*document)->surfaces()[0];
  if (surface.mesh.triangles.size() > 5000) return 0;
  const UvMap map = (*document)->asStored(0, fuzz::madeUpMap(surface.mesh));
  io::WriteOptions options;
  options.name = "out.glb";
  options.cones = R"({"format":"hgp-cones","version":1,"q":4,"cones":[]})";
  const auto written = (*document)->write(0, map, options);
  if (!written) {
    fuzz::require(written.error().code != ErrorCode::kInternal, "writing is never our bug");
    return 0;
  }
  const io::Bytes& main = written->files[0].bytes;
  io::FileSet files = fuzz::fileSet("out.glb", main.data(), main.size());
  const auto inner = files.resolve;
  files.resolve = [&](const std::string& name) -> Result<io::Bytes> {
    for (const io::OutputFile& file : written->files) {
      if (file.name == name) return file.bytes;
    }
    return inner(name);
  };
  io::Limits roomy = limits;
  roomy.maxBytes *= 8;
  const auto again = io::readGltf(files, roomy);
  if (!again) std::fprintf(stderr, "%s\n", again.error().message.c_str());
  fuzz::require(again.hasValue(), "what was written can be read");
  const io::Surface& reread = (*again)->surfaces()[0];
  fuzz::require(fuzz::isSameMesh(surface.mesh, reread.mesh), "the surface is the same");
  bool isFound = surface.mesh.triangles.empty();
  for (int set : reread.uvSets) {
    const auto uv = (*again)->existingUv(0, set);
    isFound = isFound || (uv && fuzz::isSameMap(map, *uv));
  }
  fuzz::require(isFound, "the uv are there");
  return 0;
}
