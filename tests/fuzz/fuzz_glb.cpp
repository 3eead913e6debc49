// Any bytes as a GLB: a document or a failure that says why.
#include "fuzz_support.h"
#include "glb_mutator.h"

using namespace hgp;

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t maxSize, unsigned seed) {
  return fuzz::mutateGlb(data, size, maxSize, seed);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document = io::readGltf(fuzz::fileSet("a.glb", data, size), fuzz::smallLimits());
  if (!document) {
    fuzz::require(!document.error().message.empty(), "a failure has a message");
    fuzz::require(document.error().code != ErrorCode::kInternal, "bad bytes are never our bug");
    return 0;
  }
  for (std::size_t s = 0; s < (*document)->surfaces().size(); ++s) {
    const io::Surface& surface = (*document)->surfaces()[s];
    for (const auto& triangle : surface.mesh.triangles) {
      for (int v : triangle) {
        fuzz::require(v >= 0 && v < static_cast<int>(surface.mesh.positions.size()),
                      "corners name vertices");
      }
    }
    for (int set : surface.uvSets) {
      fuzz::require((*document)->existingUv(static_cast<int>(s), set).has_value(),
                    "listed uv sets can be read");
    }
    (void)(*document)->embeddedCones(static_cast<int>(s));
  }
  return 0;
}
