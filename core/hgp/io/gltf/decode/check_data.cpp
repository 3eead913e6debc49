#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/accessor.h"

namespace hgp::io {
namespace {

Failure badIndex(const std::string& pointer, const std::string& message) {
  return {ErrorCode::kMalformed, "read", pointer + ": " + message, {}};
}

Status checkSparseIndices(const GltfStore& store, std::size_t index) {
  const GltfAccessor& accessor = store.model.accessors[index];
  const GltfSparse& sparse = *accessor.sparse;
  const ByteView bytes = store.viewBytes(sparse.indexView);
  if (bytes.empty()) return Done{};
  std::int64_t last = -1;
  for (std::uint64_t k = 0; k < sparse.count; ++k) {
    const std::int64_t at = unsignedAt(bytes.subspan(sparse.indexOffset), sparse.indexType, k);
    if (at <= last || at >= static_cast<std::int64_t>(accessor.count)) {
      return badIndex(formatText("/accessors/%zu/sparse/indices", index),
                      formatText("entry %llu is %lld; entries must increase and stay below %llu",
                                 static_cast<unsigned long long>(k), static_cast<long long>(at),
                                 static_cast<unsigned long long>(accessor.count)));
    }
    last = at;
  }
  return Done{};
}

Status checkPrimitiveIndices(const GltfStore& store, int mesh, int index) {
  const auto m = static_cast<std::size_t>(mesh);
  const GltfPrimitive& primitive =
      store.model.meshes[m].primitives[static_cast<std::size_t>(index)];
  const int position = primitive.attribute("POSITION");
  if (primitive.indices < 0 || position < 0) return Done{};
  const auto indices = readIndices(store, mesh, index);
  if (!indices) return indices.error();
  const std::uint64_t count = store.model.accessors[static_cast<std::size_t>(position)].count;
  const GltfAccessor& accessor = store.model.accessors[static_cast<std::size_t>(primitive.indices)];
  const std::uint64_t restart = (std::uint64_t{1} << (8 * accessor.componentSize())) - 1;
  for (std::size_t k = 0; k < indices->size(); ++k) {
    const std::uint32_t value = (*indices)[k];
    if (value < count && (value != restart || primitive.draco)) continue;
    return badIndex(
        formatText("/meshes/%d/primitives/%d/indices", mesh, index),
        formatText(value == restart ? "entry %zu is %u, the restart value, which glTF forbids"
                                    : "entry %zu is %u, but there are %llu vertices",
                   k, value, static_cast<unsigned long long>(count)));
  }
  return Done{};
}

}  // namespace

Status checkGltfData(const GltfStore& store) {
  for (std::size_t i = 0; i < store.model.accessors.size(); ++i) {
    if (!store.model.accessors[i].sparse) continue;
    const Status status = checkSparseIndices(store, i);
    if (!status) return status;
  }
  for (std::size_t m = 0; m < store.model.meshes.size(); ++m) {
    for (std::size_t p = 0; p < store.model.meshes[m].primitives.size(); ++p) {
      if (!store.model.meshes[m].primitives[p].isTriangles()) continue;
      const Status status = checkPrimitiveIndices(store, static_cast<int>(m), static_cast<int>(p));
      if (!status) return status;
    }
  }
  return Done{};
}

}  // namespace hgp::io
