#include "hgp/io/gltf/json/model.h"

#include <array>

namespace hgp::io {
namespace {

std::uint64_t unsignedOr(const JsonText& json, int node, std::uint64_t fallback) {
  const auto value = json.integer(node);
  return value ? static_cast<std::uint64_t>(*value) : fallback;
}

int indexOr(const JsonText& json, int node) {
  const auto value = json.integer(node);
  return value ? static_cast<int>(*value) : -1;
}

GltfMeshopt readMeshopt(const JsonText& json, int extension) {
  GltfMeshopt out;
  out.buffer = indexOr(json, json.find(extension, "buffer"));
  out.offset = unsignedOr(json, json.find(extension, "byteOffset"), 0);
  out.length = unsignedOr(json, json.find(extension, "byteLength"), 0);
  out.stride = unsignedOr(json, json.find(extension, "byteStride"), 0);
  out.count = unsignedOr(json, json.find(extension, "count"), 0);
  out.mode = json.string(json.find(extension, "mode"));
  const int filter = json.find(extension, "filter");
  out.filter = filter < 0 ? "NONE" : json.string(filter);
  return out;
}

}  // namespace

std::uint64_t gltfComponentSize(int componentType) {
  switch (componentType) {
    case 5120:
    case 5121:
      return 1;
    case 5122:
    case 5123:
      return 2;
    case 5125:
    case 5126:
      return 4;
    default:
      return 0;
  }
}

bool gltfShape(const std::string& type, GltfAccessor& out) {
  struct Shape {
    const char* name;
    int columns, rows;
  };
  static constexpr std::array kShapes = {
      Shape{"SCALAR", 1, 1}, Shape{"VEC2", 1, 2}, Shape{"VEC3", 1, 3}, Shape{"VEC4", 1, 4},
      Shape{"MAT2", 2, 2},   Shape{"MAT3", 3, 3}, Shape{"MAT4", 4, 4}};
  for (const Shape& shape : kShapes) {
    if (type != shape.name) continue;
    out.columns = shape.columns;
    out.rows = shape.rows;
    return true;
  }
  return false;
}

std::uint64_t GltfAccessor::componentSize() const { return gltfComponentSize(componentType); }

std::uint64_t GltfAccessor::elementSize() const {
  std::uint64_t column = componentSize() * static_cast<std::uint64_t>(rows);
  if (columns == 1) return column;
  column = (column + 3) / 4 * 4;
  return column * static_cast<std::uint64_t>(columns);
}

void readGltfExtensions(const JsonText& json, GltfModel& model) {
  const std::vector<int> views = json.children(json.find(JsonText::kRoot, "bufferViews"));
  for (std::size_t i = 0; i < views.size(); ++i) {
    const int extensions = json.find(views[i], "extensions");
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
      const int extension = json.find(extensions, name);
      if (extension >= 0) model.views[i].meshopt = readMeshopt(json, extension);
    }
  }
  const std::vector<int> accessors = json.children(json.find(JsonText::kRoot, "accessors"));
  for (std::size_t i = 0; i < accessors.size() && i < model.accessors.size(); ++i)
    model.accessors[i].isOwnUv =
        json.string(json.find(json.find(accessors[i], "extras"), "hgp")) == "uv";
  const std::vector<int> meshes = json.children(json.find(JsonText::kRoot, "meshes"));
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const std::vector<int> primitives = json.children(json.find(meshes[i], "primitives"));
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      GltfPrimitive& primitive = model.meshes[i].primitives[p];
      // tinygltf refuses index accessors without a view, which Draco primitives have.
      primitive.indices = indexOr(json, json.find(primitives[p], "indices"));
      const int draco =
          json.find(json.find(primitives[p], "extensions"), "KHR_draco_mesh_compression");
      if (draco < 0) continue;
      primitive.draco.emplace();
      primitive.draco->view = indexOr(json, json.find(draco, "bufferView"));
      for (int id : json.children(json.find(draco, "attributes"))) {
        primitive.draco->ids[json.key(id)] = indexOr(json, id);
      }
    }
    const int manifold = json.find(json.find(meshes[i], "extensions"), "EXT_mesh_manifold");
    const int merged = json.find(manifold, "manifoldPrimitive");
    if (merged < 0) continue;
    model.meshes[i].manifold =
        GltfManifold{indexOr(json, json.find(merged, "indices")),
                     indexOr(json, json.find(json.find(merged, "attributes"), "POSITION")),
                     indexOr(json, json.find(manifold, "mergeIndices")),
                     indexOr(json, json.find(manifold, "mergeValues"))};
  }
}

}  // namespace hgp::io
