// Any bytes as OFF, PLY or STL: a document that can be written as an OBJ and comes back, or a failure
// that says why.
#include "fuzz_support.h"

using namespace hgp;

namespace {

void requireWritable(const io::Document& document) {
  const io::Surface& surface = document.surfaces()[0];
  if (surface.mesh.triangles.empty() || surface.mesh.triangles.size() > 5000) return;
  for (const Vec3& p : surface.mesh.positions) {  // binary files can hold what is no number
    if (!std::isfinite(p[0] + p[1] + p[2])) return;
  }
  const UvMap map = document.asStored(0, fuzz::madeUpMap(surface.mesh));
  if (!fuzz::isFinite(map)) return;
  const auto written = document.write(0, map, {});
  if (!written) return;
  const io::Bytes& main = written->files[0].bytes;
  const auto again =
      io::readObj(fuzz::fileSet("b.obj", main.data(), main.size()), fuzz::smallLimits());
  if (!again) std::fprintf(stderr, "%s\n", again.error().message.c_str());
  fuzz::require(again.hasValue(), "what was written can be read");
  fuzz::require(fuzz::isSameMesh(surface.mesh, (*again)->surfaces()[0].mesh) ||
                    document.surfaces().size() > 1,
                "the surface is the same");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const char* name : {"a.off", "a.ply", "a.stl"}) {
    const auto document = io::openDocument(fuzz::fileSet(name, data, size), fuzz::smallLimits());
    if (!document) {
      fuzz::require(!document.error().message.empty(), "a failure has a message");
      fuzz::require(document.error().code != ErrorCode::kInternal, "bad bytes are never our bug");
      continue;
    }
    for (const io::Surface& surface : (*document)->surfaces()) {
      for (const auto& triangle : surface.mesh.triangles) {
        for (int v : triangle) {
          fuzz::require(v >= 0 && v < static_cast<int>(surface.mesh.positions.size()),
                        "corners name vertices");
        }
      }
    }
    if (std::strcmp((*document)->outputFormat(), "obj") == 0) requireWritable(**document);
  }
  return 0;
}
