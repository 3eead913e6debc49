#include "hgp/io/gltf/patch/grid.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/patch/splice.h"
#include "hgp/io/gltf/patch/writer.h"

namespace hgp::io {
namespace {

/// Appends to the top-level lists of a glTF and creates those that are missing.
class GltfGrid {
 public:
  GltfGrid(const JsonText& json, const std::string& scale)
      : json_(json), patch_(json), scale_(scale) {}

  std::string text() const { return patch_.text(); }

  /// An image whose bytes are appended to the binary chunk.
  std::string inChunk(std::size_t begin, std::size_t size) {
    const int buffers = json_.find(JsonText::kRoot, "buffers");
    const int buffer = json_.firstChild(buffers);
    patch_.set(buffer, "byteLength", std::to_string(begin + size));
    const int view =
        add("bufferViews",
            formatText("{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu}", begin, size));
    return formatText("\"bufferView\":%d", view);
  }

  Status assign(const std::string& image, const GltfGridPlace& grid) {
    const std::vector<int> meshes = json_.children(json_.find(JsonText::kRoot, "meshes"));
    if (grid.mesh < 0 || grid.mesh >= static_cast<int>(meshes.size())) {
      return Failure{
          ErrorCode::kUsage, "write", formatText("there is no mesh %d for a grid", grid.mesh), {}};
    }
    const std::vector<int> primitives =
        json_.children(json_.find(meshes[static_cast<std::size_t>(grid.mesh)], "primitives"));
    const int set = grid.uvSet >= 0 ? grid.uvSet : lastSet(primitives);
    const std::string semantic = "TEXCOORD_" + std::to_string(set);
    const int material = addMaterial(image, set);
    for (const int primitive : primitives) {
      if (json_.find(json_.find(primitive, "attributes"), semantic) >= 0)
        patch_.set(primitive, "material", std::to_string(material));
    }
    return Done{};
  }

 private:
  int add(std::string_view list, std::string element) {
    const int node = json_.find(JsonText::kRoot, list);
    if (json_.isArray(node)) return patch_.append(node, std::move(element));
    patch_.set(JsonText::kRoot, list, "[" + element + "]");
    return 0;
  }

  /// The set that hgp wrote, or the last one.
  int lastSet(const std::vector<int>& primitives) const {
    const int attributes = primitives.empty() ? -1 : json_.find(primitives.front(), "attributes");
    const std::vector<int> accessors = json_.children(json_.find(JsonText::kRoot, "accessors"));
    int set = 0, own = -1;
    for (int n = 0; n < 16; ++n) {
      const auto index = json_.integer(json_.find(attributes, "TEXCOORD_" + std::to_string(n)));
      if (!index || *index < 0 || static_cast<std::size_t>(*index) >= accessors.size()) continue;
      const int extras = json_.find(accessors[static_cast<std::size_t>(*index)], "extras");
      if (json_.string(json_.find(extras, "hgp")) == "uv") own = n;
    }
    if (own >= 0) return own;
    while (json_.find(attributes, "TEXCOORD_" + std::to_string(set + 1)) >= 0) ++set;
    return set;
  }

  int addMaterial(const std::string& image, int set) {
    const int source =
        add("images", "{\"name\":\"hgp grid\",\"mimeType\":\"image/png\"," + image + "}");
    const int sampler =
        add("samplers", "{\"wrapS\":10497,\"wrapT\":10497,\"magFilter\":9729,\"minFilter\":9987}");
    const int texture =
        add("textures",
            formatText("{\"name\":\"hgp grid\",\"sampler\":%d,\"source\":%d}", sampler, source));
    needTransform();
    return add("materials",
               formatText("{\"name\":\"hgp grid\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{"
                          "\"index\":%d,\"texCoord\":%d,\"extensions\":{\"KHR_texture_transform\":",
                          texture, set) +
                   "{\"scale\":[" + scale_ + "," + scale_ +
                   "]}}},\"metallicFactor\":0,\"roughnessFactor\":0.9}}");
  }

  void needTransform() {
    const std::vector<int> used = json_.children(json_.find(JsonText::kRoot, "extensionsUsed"));
    const bool isThere = std::any_of(used.begin(), used.end(), [&](int one) {
      return json_.string(one) == "KHR_texture_transform";
    });
    if (!isThere) add("extensionsUsed", "\"KHR_texture_transform\"");
  }

  const JsonText& json_;
  JsonPatch patch_;
  const std::string& scale_;
};

}  // namespace

Result<Bytes> gltfWithGrid(const Bytes& file, const GltfGridPlace& place, const std::string& scale,
                           ByteView picture) {
  Result<GltfContainer> container = openContainer(file);
  if (!container) return container.error();
  Result<JsonText> json = JsonText::parse(std::string(container->json));
  if (!json) return json.error();
  GltfGrid editor(*json, scale);
  // The first buffer of a GLB is its binary chunk only if it has no URI.
  const int buffer = json->firstChild(json->find(JsonText::kRoot, "buffers"));
  const bool isInside = container->isBinary && container->hasBin && json->find(buffer, "uri") < 0;
  Bytes bin(container->bin.begin(), container->bin.end());
  std::string image;
  if (isInside) {
    image = editor.inChunk(bin.size(), picture.size());
    bin.insert(bin.end(), picture.begin(), picture.end());
  } else {
    image = "\"uri\":\"data:image/png;base64," + encodeBase64(picture) + "\"";
  }
  if (Status done = editor.assign(image, place); !done) return done.error();
  return packContainer(*container, editor.text(), bin);
}

}  // namespace hgp::io
