// Compresses a written glTF with EXT_meshopt_compression.  Role: --compress; the extension's decoder
// reproduces every byte.
#pragma once

#include "hgp/io/document.h"

namespace hgp::io {

/// The glTF files[0], whose side files are found by name in `files` or by `resolve`, with all buffers merged
/// into one and every view compressed for which that is shorter and lossless. Accessors do not change, so
/// the certificate of the file also holds for the decoded data. A GLB stays a GLB; a .gltf gets one
/// side file "stem-packed.bin", or none if all of its buffers were data URIs. A note states the sizes.
///
/// Fails with kUsage if this build has no encoder or if the file uses an extension that may refer to
/// bytes of the buffers.
/// Whether compressGltf takes a file with the extensions of this one; texts that cannot be read are not refused here.
Status canCompressGltf(ByteView main);
Result<Written> compressGltf(const std::vector<OutputFile>& files, const Resolver& resolve,
                             const Limits& limits);

}  // namespace hgp::io
