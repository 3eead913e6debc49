// Decoders of compressed glTF data as function objects.  Role: native builds plug in libdraco and
// libmeshoptimizer; elsewhere the caller does (in JavaScript: draco3dgltf and meshoptimizer).
#pragma once

#include "hgp/io/gltf/gltf_compression.h"

namespace hgp::io {

/// What this build has of its own: both natively, none in WebAssembly.
GltfDecoders builtInDecoders();

/// Which decoders a file will ask for, from its text alone, so that they can be loaded first. A file
/// that is not readable needs none.
struct GltfNeeds {
  bool draco = false;
  bool meshopt = false;
};
GltfNeeds gltfNeeds(ByteView main);

}  // namespace hgp::io
