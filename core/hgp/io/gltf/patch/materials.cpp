// Materials that use another uv set than the one written: a note says so, or they are changed on request.
#include <algorithm>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/gltf/patch/writer.h"

namespace hgp::io {
namespace {

constexpr const char* kTransform = "KHR_texture_transform";

bool hasEnding(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Every textureInfo below `node`: an object with an index, in a member named "…Texture".
void collectTextures(const JsonText& json, int node, std::vector<int>& out) {
  for (const int member : json.children(node)) {
    const bool isTexture = json.isObject(member) && hasEnding(json.key(member), "Texture") &&
                           json.integer(json.find(member, "index"));
    if (isTexture) out.push_back(member);
    if (json.isObject(member) && json.key(member) != "extras") collectTextures(json, member, out);
  }
}

/// The set that a textureInfo uses: KHR_texture_transform overrides its own texCoord.
int setOf(const JsonText& json, int texture) {
  const int transform = json.find(json.find(texture, "extensions"), kTransform);
  const auto moved = json.integer(json.find(transform, "texCoord"));
  const auto own = json.integer(json.find(texture, "texCoord"));
  return static_cast<int>(moved.value_or(own.value_or(0)));
}

}  // namespace

bool GltfWriter::isUsedElsewhere(int material) const {
  for (std::size_t m = 0; m < store_.model.meshes.size(); ++m) {
    if (static_cast<int>(m) == part_.mesh) continue;
    for (const GltfPrimitive& p : store_.model.meshes[m].primitives)
      if (p.material == material) return true;
  }
  const auto& own = store_.model.meshes[static_cast<std::size_t>(part_.mesh)].primitives;
  return std::any_of(own.begin(), own.end(), [&](const GltfPrimitive& p) {
    return p.material == material && !p.isTriangles();
  });
}

/// A material that only this mesh uses is changed in place; one with other users is copied.
void GltfWriter::pointMaterials() {
  const int list = json_.find(JsonText::kRoot, "materials");
  const std::vector<int> materials = json_.children(list);
  std::map<int, int> copies;
  for (const GltfRun& run : part_.runs) {
    const int material = primitive(run.primitive).material;
    if (material < 0) continue;
    const int node = materials[static_cast<std::size_t>(material)];
    if (!copies.contains(material)) {
      const auto own = JsonText::parse(std::string(json_.raw(node)));
      std::vector<int> textures;
      if (own) collectTextures(*own, JsonText::kRoot, textures);
      if (textures.empty()) continue;
      JsonPatch changed(*own);
      for (const int texture : textures) {
        changed.set(texture, "texCoord", std::to_string(set_));
        const int transform = own->find(own->find(texture, "extensions"), kTransform);
        if (own->find(transform, "texCoord") >= 0)
          changed.set(transform, "texCoord", std::to_string(set_));
      }
      const bool isShared = isUsedElsewhere(material);
      copies[material] = isShared ? patch_.append(list, changed.text()) : material;
      if (!isShared) patch_.replace(node, changed.text());
    }
    if (copies[material] != material) {
      patch_.set(primitiveNodes_[static_cast<std::size_t>(run.primitive)], "material",
                 std::to_string(copies[material]));
    }
  }
  if (!copies.empty()) note(formatText("wrote TEXCOORD_%d; the materials use it", set_));
}

std::set<int> GltfWriter::setsOfMaterials() const {
  const std::vector<int> materials = json_.children(json_.find(JsonText::kRoot, "materials"));
  std::set<int> sets;
  for (const GltfRun& run : part_.runs) {
    const int material = primitive(run.primitive).material;
    if (material < 0) continue;
    std::vector<int> textures;
    collectTextures(json_, materials[static_cast<std::size_t>(material)], textures);
    for (const int texture : textures) sets.insert(setOf(json_, texture));
  }
  return sets;
}

void GltfWriter::tellOrPointMaterials() {
  std::set<int> others = setsOfMaterials();
  const bool usesWritten = others.erase(set_) > 0;
  const bool isReplaced = std::any_of(part_.runs.begin(), part_.runs.end(), [&](const auto& run) {
    return primitive(run.primitive).attribute(semantic(set_)) >= 0;
  });
  if (usesWritten && isReplaced) {
    note(formatText(
        "TEXCOORD_%d was replaced: the materials' pictures were made for the old one and "
        "no longer fit",
        set_));
  }
  if (options_.pointsMaterials && !others.empty()) return pointMaterials();
  std::string list;
  for (const int set : others) list += (list.empty() ? "" : " and ") + semantic(set);
  if (!others.empty()) note(formatText("wrote TEXCOORD_%d; the materials still use ", set_) + list);
}

}  // namespace hgp::io
