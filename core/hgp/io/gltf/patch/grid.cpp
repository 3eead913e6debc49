#include "hgp/io/gltf/patch/grid.h"

#include <algorithm>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/gltf/json/file.h"
#include "hgp/io/gltf/patch/splice.h"
#include "hgp/io/gltf/patch/writer.h"

namespace hgp::io {
namespace {

/// Appends to the top-level lists of a glTF and creates those that are missing.
class GltfGrid {
 public:
  explicit GltfGrid(const JsonText& json)
      : json_(json),
        patch_(json),
        meshes_(json.children(json.find(JsonText::kRoot, "meshes"))),
        accessors_(json.children(json.find(JsonText::kRoot, "accessors"))) {}

  std::string text() {
    for (const auto& [list, elements] : missing_)
      patch_.set(JsonText::kRoot, list, "[" + elements + "]");
    return patch_.text();
  }

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

  void addTexture(const std::string& image) {
    const int source =
        add("images", "{\"name\":\"hgp grid\",\"mimeType\":\"image/png\"," + image + "}");
    const int sampler =
        add("samplers", "{\"wrapS\":10497,\"wrapT\":10497,\"magFilter\":9729,\"minFilter\":9987}");
    texture_ = add("textures", formatText("{\"name\":\"hgp grid\",\"sampler\":%d,\"source\":%d}",
                                          sampler, source));
    needTransform();
  }

  Status assign(const GltfGridPlace& grid) {
    if (grid.mesh < 0 || grid.mesh >= static_cast<int>(meshes_.size())) {
      return Failure{
          ErrorCode::kUsage, "write", formatText("there is no mesh %d for a grid", grid.mesh), {}};
    }
    const std::vector<int> primitives =
        json_.children(json_.find(meshes_[static_cast<std::size_t>(grid.mesh)], "primitives"));
    const int set = grid.uvSet >= 0 ? grid.uvSet : lastSet(primitives);
    const std::string semantic = "TEXCOORD_" + std::to_string(set);
    const int material = addMaterial(set, grid.scale);
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
    std::string& elements = missing_[std::string(list)];
    elements += (elements.empty() ? "" : ",") + element;
    return missingCount_[std::string(list)]++;
  }

  /// The set that hgp wrote, or the last one.
  int lastSet(const std::vector<int>& primitives) const {
    const int attributes = primitives.empty() ? -1 : json_.find(primitives.front(), "attributes");
    int set = 0, own = -1;
    for (int n = 0; n < 16; ++n) {
      const auto index = json_.integer(json_.find(attributes, "TEXCOORD_" + std::to_string(n)));
      if (!index || *index < 0 || static_cast<std::size_t>(*index) >= accessors_.size()) continue;
      const int extras = json_.find(accessors_[static_cast<std::size_t>(*index)], "extras");
      if (json_.string(json_.find(extras, "hgp")) == "uv") own = n;
    }
    if (own >= 0) return own;
    while (json_.find(attributes, "TEXCOORD_" + std::to_string(set + 1)) >= 0) ++set;
    return set;
  }

  int addMaterial(int set, const std::string& scale) {
    return add("materials",
               formatText("{\"name\":\"hgp grid\",\"pbrMetallicRoughness\":{\"baseColorTexture\":{"
                          "\"index\":%d,\"texCoord\":%d,\"extensions\":{\"KHR_texture_transform\":",
                          texture_, set) +
                   "{\"scale\":[" + scale + "," + scale +
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
  std::vector<int> meshes_, accessors_;
  int texture_ = 0;
  std::map<std::string, std::string>
      missing_;  ///< lists that the file does not have: their elements
  std::map<std::string, int> missingCount_;
};

}  // namespace

Result<Bytes> gltfWithGrids(const Bytes& file, const std::vector<GltfGridPlace>& places,
                            ByteView picture) {
  Result<GltfContainer> container = openContainer(file);
  if (!container) return container.error();
  Result<JsonText> json = JsonText::parse(std::string(container->json));
  if (!json) return json.error();
  GltfGrid editor(*json);
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
  editor.addTexture(image);
  for (const GltfGridPlace& place : places)
    if (Status done = editor.assign(place); !done) return done.error();
  return packContainer(*container, editor.text(), bin);
}

}  // namespace hgp::io
