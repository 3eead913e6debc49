// The only source that includes tinygltf, which receives a text with nothing but accessors, views
// and meshes, all checked before; it opens no file and decodes nothing.
#include <fstream>  // tinygltf does not include it under TINYGLTF_NO_FS, although it needs it

#include "hgp/io/gltf/json/text_stream.h"

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define tinygltf hgp_tinygltf  // of our own, since programs that link this library may have another
#include <tiny_gltf.h>
#undef tinygltf

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/model.h"

namespace hgp::io {
namespace {

namespace tinygltf = hgp_tinygltf;

/// Builds the text for tinygltf from pieces of the original text.
class ReducedText {
 public:
  explicit ReducedText(const JsonText& json) : json_(json) {}

  std::string build() {
    text_ = R"({"asset":{"version":"2.0"})";
    const std::vector<int> accessors = list("accessors");
    for (int a : accessors) hasView_.push_back(json_.find(a, "bufferView") >= 0);
    array("accessors", accessors, [&](int a) { accessor(a); });
    array("bufferViews", list("bufferViews"), [&](int view) {
      members(view, {"buffer", "byteOffset", "byteLength", "byteStride", "target"});
    });
    array("meshes", list("meshes"), [&](int mesh) {
      members(mesh, {"name"});
      array("primitives", json_.children(json_.find(mesh, "primitives")),
            [&](int p) { primitive(p); });
    });
    return text_ + "}";
  }

 private:
  std::vector<int> list(const char* name) const {
    return json_.children(json_.find(JsonText::kRoot, name));
  }

  template <class Body>
  void array(const char* name, const std::vector<int>& elements, const Body& body) {
    separate();
    text_ += '"' + std::string(name) + "\":[";
    for (int element : elements) {
      separate();
      text_ += '{';
      body(element);
      text_ += '}';
    }
    text_ += ']';
  }

  void separate() {
    if (text_.back() != '{' && text_.back() != '[') text_ += ',';
  }

  void members(int object, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      const int member = json_.find(object, name);
      if (member < 0) continue;
      separate();
      text_ += '"' + std::string(name) + "\":";
      text_ += json_.raw(member);
    }
  }

  void accessor(int a) {
    members(a, {"bufferView", "byteOffset", "componentType", "normalized", "count", "type"});
    const int sparse = json_.find(a, "sparse");
    if (sparse < 0) return;
    text_ += ",\"sparse\":{";
    members(sparse, {"count"});
    text_ += ",\"indices\":{";
    members(json_.find(sparse, "indices"), {"bufferView", "byteOffset", "componentType"});
    text_ += "},\"values\":{";
    members(json_.find(sparse, "values"), {"bufferView", "byteOffset"});
    text_ += "}}";
  }

  void primitive(int p) {
    members(p, {"mode", "material", "attributes", "targets"});
    const auto indices = json_.integer(json_.find(p, "indices"));
    if (indices && hasView_[static_cast<std::size_t>(*indices)]) members(p, {"indices"});
  }

  const JsonText& json_;
  std::string text_;
  std::vector<bool> hasView_;
};

GltfView convert(const tinygltf::BufferView& view) {
  GltfView out;
  out.buffer = view.buffer;
  out.offset = view.byteOffset;
  out.length = view.byteLength;
  out.stride = view.byteStride;
  return out;
}

GltfAccessor convert(const tinygltf::Accessor& accessor) {
  GltfAccessor out;
  out.view = accessor.bufferView;
  out.offset = accessor.byteOffset;
  out.count = accessor.count;
  out.componentType = accessor.componentType;
  out.isNormalized = accessor.normalized;
  const bool isMatrix = accessor.type >= TINYGLTF_TYPE_MAT2 && accessor.type <= TINYGLTF_TYPE_MAT4;
  const int components =
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
  out.columns = !isMatrix                             ? 1
                : accessor.type == TINYGLTF_TYPE_MAT2 ? 2
                : accessor.type == TINYGLTF_TYPE_MAT3 ? 3
                                                      : 4;
  out.rows = components / out.columns;
  if (accessor.sparse.isSparse) {
    out.sparse.emplace();
    out.sparse->count = static_cast<std::uint64_t>(accessor.sparse.count);
    out.sparse->indexView = accessor.sparse.indices.bufferView;
    out.sparse->indexType = accessor.sparse.indices.componentType;
    out.sparse->indexOffset = static_cast<std::uint64_t>(accessor.sparse.indices.byteOffset);
    out.sparse->valueView = accessor.sparse.values.bufferView;
    out.sparse->valueOffset = static_cast<std::uint64_t>(accessor.sparse.values.byteOffset);
  }
  return out;
}

GltfMesh convert(const tinygltf::Mesh& mesh) {
  GltfMesh out;
  out.name = mesh.name;
  for (const tinygltf::Primitive& primitive : mesh.primitives) {
    GltfPrimitive& p = out.primitives.emplace_back();
    p.mode = primitive.mode;
    p.material = primitive.material;
    p.attributes = primitive.attributes;
    p.targets = primitive.targets;
  }
  return out;
}

/// tinygltf silently drops what it cannot read; nothing may be lost here.
bool isComplete(const JsonText& json, const GltfModel& model) {
  const auto size = [&](const char* name) {
    return json.children(json.find(JsonText::kRoot, name)).size();
  };
  if (model.views.size() != size("bufferViews") || model.accessors.size() != size("accessors") ||
      model.meshes.size() != size("meshes")) {
    return false;
  }
  const std::vector<int> meshes = json.children(json.find(JsonText::kRoot, "meshes"));
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::vector<int> primitives = json.children(json.find(meshes[m], "primitives"));
    if (primitives.size() != model.meshes[m].primitives.size()) return false;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const GltfPrimitive& primitive = model.meshes[m].primitives[p];
      const int attributes = json.find(primitives[p], "attributes");
      const int targets = json.find(primitives[p], "targets");
      if (primitive.attributes.size() != json.children(attributes).size() ||
          primitive.targets.size() != json.children(targets).size()) {
        return false;
      }
    }
  }
  return true;
}

}  // namespace

Result<GltfModel> readGltfModel(const JsonText& json) {
  const std::string text = ReducedText(json).build();
  tinygltf::TinyGLTF loader;
  tinygltf::Model read;
  std::string errors, warnings;
  if (!loader.LoadASCIIFromString(&read, &errors, &warnings, text.data(),
                                  static_cast<unsigned>(text.size()), "")) {
    return Failure{ErrorCode::kMalformed, "read", "not a readable glTF file: " + errors, {}};
  }
  GltfModel model;
  for (const auto& view : read.bufferViews) model.views.push_back(convert(view));
  for (const auto& accessor : read.accessors) model.accessors.push_back(convert(accessor));
  for (const auto& mesh : read.meshes) model.meshes.push_back(convert(mesh));
  if (!isComplete(json, model)) {
    return Failure{ErrorCode::kMalformed,
                   "read",
                   "not a readable glTF file: a mesh could not be read " + errors,
                   {}};
  }
  readGltfExtensions(json, model);
  return model;
}

}  // namespace hgp::io
