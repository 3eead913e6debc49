// The elements of accessors of any component type: interleaved, sparse, normalized or compressed.
// Role: the only place that knows how glTF stores numbers. @pre the store has been checked
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/io/gltf/decode/store.h"

namespace hgp::io {

/// The k-th unsigned integer of a tightly packed array (component type 5121, 5123 or 5125).
std::uint32_t unsignedAt(ByteView bytes, int componentType, std::uint64_t k);

/// The elements as stored, tightly packed, with the sparse values substituted.
Bytes packedElements(const GltfStore& store, int accessor);
/// The same for an attribute of a primitive, taken from its Draco data where those contain it.
/// @param target  index of a morph target; −1: the base shape
Bytes packedAttribute(const GltfStore& store, int mesh, int primitive, const std::string& semantic,
                      int target = -1);

/// Packed elements as real numbers, the components of an element next to each other; normalized integers are
/// converted by the rule of glTF 2.0, §3.6.2.2.
std::vector<double> realNumbers(const GltfAccessor& shape, ByteView packed);

/// The vertex indices of a primitive, decoded; 0, 1, 2, … for a primitive without indices.
Result<std::vector<std::uint32_t>> readIndices(const GltfStore& store, int mesh, int primitive);

}  // namespace hgp::io
