// Decodes, once, what triangle primitives need, and checks the sizes and indices of the results.
#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/decoders.h"
#include "hgp/io/gltf/decode/store.h"

namespace hgp::io {
namespace {

Failure failureAt(ErrorCode code, const std::string& pointer, const std::string& message) {
  return {code, "read", pointer + ": " + message, {}};
}

void needAccessor(const GltfStore& store, int index, std::set<int>& views) {
  if (index < 0) return;
  const GltfAccessor& accessor = store.model.accessors[static_cast<std::size_t>(index)];
  if (accessor.view >= 0) views.insert(accessor.view);
  if (!accessor.sparse) return;
  views.insert(accessor.sparse->indexView);
  views.insert(accessor.sparse->valueView);
}

/// Views that triangle meshes read from.
std::set<int> neededViews(const GltfStore& store) {
  std::set<int> views;
  for (const GltfMesh& mesh : store.model.meshes) {
    for (const GltfPrimitive& primitive : mesh.primitives) {
      if (!primitive.isTriangles()) continue;
      needAccessor(store, primitive.indices, views);
      for (const auto& [semantic, accessor] : primitive.attributes) {
        needAccessor(store, accessor, views);
      }
      for (const GltfAttributes& target : primitive.targets) {
        for (const auto& [semantic, accessor] : target) needAccessor(store, accessor, views);
      }
      if (primitive.draco) views.insert(primitive.draco->view);
    }
    if (mesh.manifold) needAccessor(store, mesh.manifold->indices, views);
  }
  return views;
}

Failure withoutDecoder(const std::string& pointer, const char* compression) {
  return failureAt(ErrorCode::kUnsupported, pointer,
                   formatText("compressed with %s, for which no decoder was loaded; export it "
                              "uncompressed, or call prepare() before load() (hgp/core)",
                              compression));
}

Status decodeView(GltfStore& store, int index, const GltfDecoders& decoders) {
  const GltfView& view = store.model.views[static_cast<std::size_t>(index)];
  const GltfMeshopt& meshopt = *view.meshopt;
  const std::string pointer = formatText("/bufferViews/%d", index);
  if (!decoders.meshopt) {
    return withoutDecoder(pointer, "meshopt");
  }
  MeshoptRequest request;
  request.source = store.buffers[static_cast<std::size_t>(meshopt.buffer)].bytes.subspan(
      meshopt.offset, meshopt.length);
  request.count = meshopt.count;
  request.stride = meshopt.stride;
  request.mode = meshopt.mode;
  request.filter = meshopt.filter;
  auto bytes = decoders.meshopt(request);
  if (!bytes) return failureAt(bytes.error().code, pointer, bytes.error().message);
  if (bytes->size() != view.length) {
    return failureAt(ErrorCode::kMalformed, pointer,
                     formatText("the meshopt data decode to %zu bytes, not %llu", bytes->size(),
                                static_cast<unsigned long long>(view.length)));
  }
  store.decodedViews[index] = std::move(*bytes);
  return Done{};
}

/// Decodes the Draco data of one primitive; without a decoder its uncompressed fallback is used, if it has one.
Status decodeDraco(GltfStore& store, int mesh, int index, const GltfDecoders& decoders) {
  const auto m = static_cast<std::size_t>(mesh);
  const GltfPrimitive& primitive =
      store.model.meshes[m].primitives[static_cast<std::size_t>(index)];
  const auto accessor = [&](int a) -> const GltfAccessor& {
    return store.model.accessors[static_cast<std::size_t>(a)];
  };
  const std::string pointer = formatText("/meshes/%d/primitives/%d", mesh, index);
  if (!decoders.draco) {
    const int position = primitive.attribute("POSITION");
    if (position < 0 || accessor(position).view >= 0) return Done{};
    return withoutDecoder(pointer, "Draco");
  }
  if (primitive.mode != 4) {
    return failureAt(ErrorCode::kUnsupported, pointer,
                     "strips and fans compressed with Draco are not supported; export triangles");
  }
  DracoRequest request;
  request.source = store.viewBytes(primitive.draco->view);
  request.indexCount = accessor(primitive.indices).count;
  std::vector<std::string> semantics;
  for (const auto& [semantic, id] : primitive.draco->ids) {
    const GltfAccessor& shape = accessor(primitive.attributes.at(semantic));
    request.attributes.push_back({id, shape.componentType, shape.components()});
    request.vertexCount = shape.count;
    semantics.push_back(semantic);
  }
  if (semantics.empty())
    return failureAt(ErrorCode::kMalformed, pointer, "the Draco extension lists no attributes");
  auto decoded = decoders.draco(request);
  if (!decoded) return failureAt(decoded.error().code, pointer, decoded.error().message);
  bool isAsAsked = decoded->indices.size() == request.indexCount &&
                   decoded->attributes.size() == semantics.size();
  GltfDracoData data;
  for (std::size_t k = 0; isAsAsked && k < semantics.size(); ++k) {
    const GltfAccessor& shape = accessor(primitive.attributes.at(semantics[k]));
    isAsAsked = decoded->attributes[k].size() == shape.count * shape.elementSize();
    data.attributes[semantics[k]] = std::move(decoded->attributes[k]);
  }
  for (std::uint32_t i : decoded->indices) isAsAsked = isAsAsked && i < request.vertexCount;
  if (!isAsAsked) {
    return failureAt(ErrorCode::kMalformed, pointer,
                     "the Draco data does not have the sizes that the accessors state");
  }
  data.indices = std::move(decoded->indices);
  store.decodedDraco[{mesh, index}] = std::move(data);
  return Done{};
}

}  // namespace

Status decodeGltf(GltfStore& store, const GltfDecoders& decoders) {
  for (int view : neededViews(store)) {
    if (!store.model.views[static_cast<std::size_t>(view)].meshopt) continue;
    const Status status = decodeView(store, view, decoders);
    if (!status) return status;
  }
  for (std::size_t m = 0; m < store.model.meshes.size(); ++m) {
    for (std::size_t p = 0; p < store.model.meshes[m].primitives.size(); ++p) {
      const GltfPrimitive& primitive = store.model.meshes[m].primitives[p];
      if (!primitive.draco || !primitive.isTriangles()) continue;
      const Status status = decodeDraco(store, static_cast<int>(m), static_cast<int>(p), decoders);
      if (!status) return status;
    }
  }
  return Done{};
}

GltfNeeds gltfNeeds(ByteView main) {
  GltfNeeds needs;
  const auto container = openContainer(main);
  if (!container) return needs;
  const auto json = JsonText::parse(std::string(container->json));
  if (!json) return needs;
  for (int name : json->children(json->find(JsonText::kRoot, "extensionsUsed"))) {
    const std::string extension = json->string(name);
    needs.draco = needs.draco || extension == "KHR_draco_mesh_compression";
    needs.meshopt = needs.meshopt || extension == "EXT_meshopt_compression" ||
                    extension == "KHR_meshopt_compression";
  }
  return needs;
}

}  // namespace hgp::io
