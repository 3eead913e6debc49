// Decoders of compressed glTF data as function objects.  Role: native builds plug in libdraco and
// libmeshoptimizer; elsewhere the caller does (in JavaScript: draco3dgltf and meshoptimizer).
#pragma once

#include "hgp/io/gltf/decode/compression.h"

namespace hgp::io {

/// The decoders linked into this build: natively those that were installed, none in WebAssembly.
GltfDecoders builtInDecoders();

/// Which decoders a file needs, determined from its text alone so that they can be loaded before it is read. A
/// file that cannot be read needs none.
struct GltfNeeds {
  bool draco = false;
  bool meshopt = false;
};
GltfNeeds gltfNeeds(ByteView main);

}  // namespace hgp::io
