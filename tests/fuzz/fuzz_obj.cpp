// Any text as an OBJ; what can be read can be written and comes back.
#include "fuzz_support.h"

using namespace hgp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document = io::readObj(fuzz::fileSet("a.obj", data, size), fuzz::smallLimits());
  if (!document) {
    fuzz::require(document.error().code != ErrorCode::kInternal, "bad bytes are never our bug");
    return 0;
  }
  const io::Surface& surface = (*document)->surfaces()[0];
  if (surface.mesh.triangles.empty() || surface.mesh.triangles.size() > 5000) return 0;
  const UvMap map = (*document)->asStored(0, fuzz::madeUpMap(surface.mesh));
  // A polygon without area has no motion to carry its triangles by; a certificate refuses such maps.
  if (!fuzz::isFinite(map)) return 0;
  const auto written = (*document)->write(0, map, {});
  if (!written) return 0;
  const io::Bytes& main = written->files[0].bytes;
  const auto again =
      io::readObj(fuzz::fileSet("b.obj", main.data(), main.size()), fuzz::smallLimits());
  if (!again) std::fprintf(stderr, "%s\n", again.error().message.c_str());
  fuzz::require(again.hasValue(), "what was written can be read");
  fuzz::require(fuzz::isSameMesh(surface.mesh, (*again)->surfaces()[0].mesh),
                "the surface is the same");
  const auto uv = (*again)->existingUv(0, 0);
  fuzz::require(uv && fuzz::isSameMap(map, *uv), "the uv are there");
  return 0;
}
