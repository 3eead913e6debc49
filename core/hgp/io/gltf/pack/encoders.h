// Lossless compression of buffer views by meshopt.  Role: the encoder behind --compress; only in native builds
// with libmeshoptimizer.
#pragma once

#include <optional>

#include "hgp/io/gltf/decode/compression.h"

namespace hgp::io {

/// What the elements of a view are.
enum class GltfContent {
  kIndices,  ///< unsigned integers of `stride` bytes, 2 or 4
  kFloats,   ///< elements that are float32 throughout
  kOther,
};

/// One view, compressed, with the properties that EXT_meshopt_compression states for it.
struct PackedView {
  Bytes bytes;
  std::uint64_t count = 0, stride = 0;
  const char* mode = "ATTRIBUTES";
  const char* filter = "NONE";
};

/// Whether this build has an encoder.
bool canPackViews();

/// The shortest encoding from which the decoder reproduces exactly these bytes; empty if none is shorter than
/// the bytes themselves, or if meshopt cannot encode them (the stride of attributes must be a multiple of 4, at
/// most 256). Mode TRIANGLES is used only where it rotates the corners of no triangle. The filter EXPONENTIAL is
/// lossless for floats on a grid 2^−m, such as uv.
/// @pre bytes.size() is a multiple of stride
std::optional<PackedView> packView(ByteView bytes, std::uint64_t stride, GltfContent content);

/// Floats as the filter EXPONENTIAL stores them, with 8 bits of exponent and a signed mantissa of 24 bits; the
/// values of a component share one exponent where they fit. Empty if a value has no such form.
/// @pre stride is a multiple of 4 that divides bytes.size()
std::optional<Bytes> exponentialFilter(ByteView bytes, std::uint64_t stride);

}  // namespace hgp::io
