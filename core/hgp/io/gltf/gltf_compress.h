// A written glTF with EXT_meshopt_compression.  Role: --compress; what the extension's decoder gives back is
// every byte that was there.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// The glTF in `files` (the first, side files by name among the others or by `resolve`) with all buffers laid
/// into one and its views packed where that is shorter and lossless. Accessors do not change, so that
/// what was certified of the file holds for what is decoded. A GLB stays one; a .gltf gets one
/// side file "stem-packed.bin", or none where all of its buffers were data URIs. A note says the sizes.
///
/// kUnsupported: this build cannot, or the file uses an extension that may point into the buffers.
Result<Written> compressGltf(const std::vector<OutputFile>& files, const Resolver& resolve,
                             const Limits& limits);

}  // namespace hgp::io
