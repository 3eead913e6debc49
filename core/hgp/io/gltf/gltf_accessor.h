// Accessor elements out of bytes: any component type, interleaved, sparse, normalized, compressed.
// Role: the only place that knows how glTF stores numbers. @pre the store has been checked
#pragma once

#include <cstdint>
#include <vector>

#include "hgp/io/gltf/gltf_store.h"

namespace hgp::io {

/// The k-th unsigned integer of a tightly packed array (component type 5121, 5123 or 5125).
std::uint32_t unsignedAt(ByteView bytes, int componentType, std::uint64_t k);

/// Elements as stored, tightly packed, sparse values put in.
Bytes packedElements(const GltfStore& store, int accessor);
/// … of an attribute of a primitive, from Draco where Draco holds it. `target` −1: the base shape.
Bytes packedAttribute(const GltfStore& store, int mesh, int primitive, const std::string& semantic,
                      int target = -1);

/// Packed elements as real numbers, components side by side; normalized integers as glTF says.
std::vector<double> realNumbers(const GltfAccessor& shape, ByteView packed);

/// The indices of a primitive as they are used: decoded, or counted up where there are none.
Result<std::vector<std::uint32_t>> readIndices(const GltfStore& store, int mesh, int primitive);

}  // namespace hgp::io
