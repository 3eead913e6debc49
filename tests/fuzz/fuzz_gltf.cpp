// Any text as a .gltf: names beside the file are the only thing that is ever asked for.
#include "fuzz_support.h"

using namespace hgp;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto document = io::readGltf(fuzz::fileSet("a.gltf", data, size), fuzz::smallLimits());
  if (!document) {
    fuzz::require(document.error().code != ErrorCode::kInternal, "bad bytes are never our bug");
  }
  return 0;
}
