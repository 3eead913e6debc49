#include "hgp/io/gltf/gltf_store.h"

#include "hgp/base/check.h"
#include "hgp/io/gltf/gltf_accessor.h"
#include "hgp/io/gltf/gltf_check.h"

namespace hgp::io {
namespace {

Failure malformed(const std::string& pointer, const std::string& message) {
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
      return malformed(formatText("/accessors/%zu/sparse/indices", index),
                       formatText("entry %llu is %lld; they must increase and stay below %llu",
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
    return malformed(
        formatText("/meshes/%d/primitives/%d/indices", mesh, index),
        formatText(value == restart ? "entry %zu is %u, the restart value, which may not be used"
                                    : "entry %zu is %u, but there are %llu vertices",
                   k, value, static_cast<unsigned long long>(count)));
  }
  return Done{};
}

}  // namespace

ByteView GltfStore::viewBytes(int index) const {
  const GltfView& view = model.views[static_cast<std::size_t>(index)];
  if (view.meshopt) {
    const auto found = decodedViews.find(index);
    return found == decodedViews.end() ? ByteView() : ByteView(found->second);
  }
  return buffers[static_cast<std::size_t>(view.buffer)].bytes.subspan(view.offset, view.length);
}

ByteView GltfStore::accessorBytes(const GltfAccessor& accessor) const {
  if (accessor.view < 0) return {};
  const ByteView bytes = viewBytes(accessor.view);
  return bytes.empty() ? bytes : bytes.subspan(accessor.offset);
}

std::uint64_t GltfStore::accessorStride(const GltfAccessor& accessor) const {
  const std::uint64_t stride =
      accessor.view < 0 ? 0 : model.views[static_cast<std::size_t>(accessor.view)].stride;
  return stride == 0 ? accessor.elementSize() : stride;
}

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

Result<std::unique_ptr<GltfStore>> loadGltf(FileSet files, const Limits& limits,
                                            const GltfDecoders& decoders) {
  auto container = openContainer(files.main);
  if (!container) return container.error();
  auto json = JsonText::parse(std::string(container->json));
  if (!json) return json.error();
  Status status = checkGltf(*json, limits);
  if (!status) return status.error();
  auto model = readGltfModel(*json);
  if (!model) return model.error();

  auto store = std::make_unique<GltfStore>();
  store->name = std::move(files.name);
  store->json = std::move(*json);
  store->model = std::move(*model);
  store->container = std::move(*container);
  store->container.json = {};
  if (store->container.isBinary) store->file = std::move(files.main);
  status = loadGltfBuffers(*store, files.resolve, limits);
  if (status) status = decodeGltf(*store, decoders);
  if (status) status = checkGltfData(*store);
  if (!status) return status.error();
  return store;
}

}  // namespace hgp::io
