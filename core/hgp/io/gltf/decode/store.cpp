#include "hgp/io/gltf/decode/store.h"

#include "hgp/io/gltf/check/check.h"

namespace hgp::io {
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
