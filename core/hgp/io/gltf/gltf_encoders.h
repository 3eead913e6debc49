// Buffer views packed by meshopt without losing a bit.  Role: what --compress is made of; native builds with
// libmeshoptimizer only.
#pragma once

#include <optional>

#include "hgp/io/gltf/gltf_compression.h"

namespace hgp::io {

/// What a view is made of.
enum class GltfContent {
  kIndices,  ///< unsigned integers of `stride` bytes, 2 or 4
  kFloats,   ///< elements that are float32 throughout
  kOther,
};

/// EXT_meshopt_compression of one view.
struct PackedView {
  Bytes bytes;
  std::uint64_t count = 0, stride = 0;
  const char* mode = "ATTRIBUTES";
  const char* filter = "NONE";
};

/// Whether this build packs at all.
bool canPackViews();

/// The shortest packing from which the decoder gives back exactly these bytes; nothing where none is shorter
/// than they are, or where meshopt does not take them (attributes: stride a multiple of 4, at most 256).
/// Lists of triangles are packed as such only where no triangle is rotated by it. Of floats that lie on a grid
/// 2^−m, as uv do, the filter EXPONENTIAL holds every bit.
/// @pre bytes.size() is a multiple of stride
std::optional<PackedView> packView(ByteView bytes, std::uint64_t stride, GltfContent content);

/// Floats as the filter EXPONENTIAL stores them, 8 bits of exponent and 24 of a signed mantissa, one exponent
/// for a component where its values fit; nothing where a value has no such form.
/// @pre stride is a multiple of 4 that divides bytes.size()
std::optional<Bytes> exponentialFilter(ByteView bytes, std::uint64_t stride);

}  // namespace hgp::io
