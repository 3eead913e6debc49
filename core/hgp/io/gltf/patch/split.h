// Copies of vertices whose corners have different uv.  Role: the table written vertex → stored vertex from which
// every attribute is rewritten.
#pragma once

#include <array>
#include <vector>

#include "hgp/io/gltf/decode/weld.h"

namespace hgp::io {

/// One pool after splitting: written vertices 0 … vertexCount − 1 are the stored ones; copies follow.
struct GltfSplit {
  std::vector<int> copyOf;  ///< of the copies: index of the stored vertex in the pool
  std::vector<float> uv;    ///< 2 per written vertex, v from the top
};

struct GltfSplits {
  std::vector<GltfSplit> pools;
  std::vector<std::array<int, 3>> corner;  ///< |F| × 3 written vertices of the triangle's pool
};

/// Corners without uv (index −1) get any copy of their vertex. Fails with kWriteFailed if the map does not
/// have one entry per triangle of the surface or is not exact in float32 with v measured from the top.
Result<GltfSplits> splitForUv(const GltfSurface& part, const UvMap& map);

}  // namespace hgp::io
