// The header of a Draco stream.  Role: a stream that states larger counts than its accessors is
// refused before a decoder allocates memory for it.
#pragma once

#include "hgp/io/gltf/decode/compression.h"

namespace hgp::io {

/// Checks that the stream is a mesh of bitstream version 2.2 whose face and vertex counts are those of the
/// request (edgebreaker states the number of vertices before they are split at seams, which is never larger).
Status checkDracoHeader(const DracoRequest& request);

}  // namespace hgp::io
