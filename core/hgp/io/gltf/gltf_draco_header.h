// The first numbers of a Draco stream.  Role: a stream that claims more than its accessors is
// refused before a decoder allocates for it.
#pragma once

#include "hgp/io/gltf/gltf_compression.h"

namespace hgp::io {

/// Checks that the stream is a mesh of bitstream version 2.2 whose face and vertex counts are those
/// of the request (edgebreaker states the vertices before seams split them: never more).
Status checkDracoHeader(const DracoRequest& request);

}  // namespace hgp::io
