#include "hgp/io/gltf/decode/accessor.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace hgp::io {
namespace {

/// glTF is little-endian, as is every platform that we build for.
template <class T>
T valueAt(ByteView bytes, std::uint64_t k) {
  T value;
  std::memcpy(&value, bytes.data() + k * sizeof(T), sizeof(T));
  return value;
}

double realAt(ByteView bytes, std::uint64_t k, int componentType, bool isNormalized) {
  switch (componentType) {
    case 5120: {
      const double value = valueAt<std::int8_t>(bytes, k);
      return isNormalized ? std::max(value / 127.0, -1.0) : value;
    }
    case 5121:
      return isNormalized ? bytes[k] / 255.0 : bytes[k];
    case 5122: {
      const double value = valueAt<std::int16_t>(bytes, k);
      return isNormalized ? std::max(value / 32767.0, -1.0) : value;
    }
    case 5123: {
      const double value = valueAt<std::uint16_t>(bytes, k);
      return isNormalized ? value / 65535.0 : value;
    }
    case 5125:
      return valueAt<std::uint32_t>(bytes, k);
    default:
      return static_cast<double>(valueAt<float>(bytes, k));
  }
}

}  // namespace

std::uint32_t unsignedAt(ByteView bytes, int componentType, std::uint64_t k) {
  if (componentType == kGltfUnsignedByte) return bytes[k];
  if (componentType == kGltfUnsignedShort) return valueAt<std::uint16_t>(bytes, k);
  return valueAt<std::uint32_t>(bytes, k);
}

Bytes packedElements(const GltfStore& store, int index) {
  const GltfAccessor& accessor = store.model.accessors[static_cast<std::size_t>(index)];
  const std::uint64_t size = accessor.elementSize();
  Bytes out(accessor.count * size, 0);
  const ByteView source = store.accessorBytes(accessor);
  const std::uint64_t stride = store.accessorStride(accessor);
  if (!source.empty() && stride == size) {
    std::memcpy(out.data(), source.data(), out.size());
  } else if (!source.empty()) {
    for (std::uint64_t i = 0; i < accessor.count; ++i) {
      std::memcpy(out.data() + i * size, source.data() + i * stride, size);
    }
  }
  if (!accessor.sparse) return out;
  const GltfSparse& sparse = *accessor.sparse;
  const ByteView where = store.viewBytes(sparse.indexView).subspan(sparse.indexOffset);
  const ByteView values = store.viewBytes(sparse.valueView).subspan(sparse.valueOffset);
  for (std::uint64_t k = 0; k < sparse.count; ++k) {
    std::memcpy(out.data() + unsignedAt(where, sparse.indexType, k) * size,
                values.data() + k * size, size);
  }
  return out;
}

Bytes packedAttribute(const GltfStore& store, int mesh, int primitive, const std::string& semantic,
                      int target) {
  const GltfPrimitive& p = store.model.meshes[static_cast<std::size_t>(mesh)]
                               .primitives[static_cast<std::size_t>(primitive)];
  if (target >= 0) {
    return packedElements(store, p.targets[static_cast<std::size_t>(target)].at(semantic));
  }
  if (p.draco) {
    const auto decoded = store.decodedDraco.find({mesh, primitive});
    if (decoded != store.decodedDraco.end()) {
      const auto found = decoded->second.attributes.find(semantic);
      if (found != decoded->second.attributes.end()) return found->second;
    }
  }
  return packedElements(store, p.attributes.at(semantic));
}

std::vector<double> realNumbers(const GltfAccessor& shape, ByteView packed) {
  const std::uint64_t total = shape.count * static_cast<std::uint64_t>(shape.components());
  std::vector<double> out(total);
  for (std::uint64_t k = 0; k < total; ++k) {
    out[k] = realAt(packed, k, shape.componentType, shape.isNormalized);
  }
  return out;
}

Result<std::vector<std::uint32_t>> readIndices(const GltfStore& store, int mesh, int primitive) {
  const GltfPrimitive& p = store.model.meshes[static_cast<std::size_t>(mesh)]
                               .primitives[static_cast<std::size_t>(primitive)];
  const auto decoded = store.decodedDraco.find({mesh, primitive});
  if (decoded != store.decodedDraco.end()) return decoded->second.indices;
  std::vector<std::uint32_t> out;
  if (p.indices < 0) {
    const int position = p.attribute("POSITION");
    if (position < 0) return out;
    out.resize(store.model.accessors[static_cast<std::size_t>(position)].count);
    std::iota(out.begin(), out.end(), 0u);
    return out;
  }
  const GltfAccessor& accessor = store.model.accessors[static_cast<std::size_t>(p.indices)];
  const Bytes packed = packedElements(store, p.indices);
  out.resize(accessor.count);
  for (std::uint64_t k = 0; k < accessor.count; ++k) {
    out[k] = unsignedAt(packed, accessor.componentType, k);
  }
  return out;
}

}  // namespace hgp::io
