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

/// The text of a material whose textures use the set.
std::string withSet(const std::string& material, int set) {
  const auto own = JsonText::parse(material);
  if (!own) return material;
  std::vector<int> textures;
  collectTextures(*own, JsonText::kRoot, textures);
  JsonPatch changed(*own);
  for (const int texture : textures) {
    changed.set(texture, "texCoord", std::to_string(set));
    const int transform = own->find(own->find(texture, "extensions"), kTransform);
    if (own->find(transform, "texCoord") >= 0)
      changed.set(transform, "texCoord", std::to_string(set));
  }
  return changed.text();
}

}  // namespace

/// Records which primitives use their material with the written set; pointMaterials() carries it out for all meshes.
void GltfWriter::planMaterials() {
  bool isAny = false;
  for (const GltfRun& run : part_->runs) {
    const int material = primitive(run.primitive).material;
    if (material < 0) continue;
    std::vector<int> textures;
    collectTextures(json_, materialNodes_[static_cast<std::size_t>(material)], textures);
    if (textures.empty()) continue;
    pointed_[material][set_].push_back(primitiveNodes_[static_cast<std::size_t>(run.primitive)]);
    isAny = true;
  }
  if (isAny) note("write-set-used", {{"set", set_}});
}

/// A material whose every user is pointed to one set is changed in place; others are copied, once per set.
void GltfWriter::pointMaterials() {
  if (pointed_.empty()) return;
  std::map<int, std::size_t> users;
  for (const GltfMesh& mesh : store_.model.meshes)
    for (const GltfPrimitive& p : mesh.primitives) ++users[p.material];
  const int list = json_.find(JsonText::kRoot, "materials");
  for (const auto& [material, sets] : pointed_) {
    std::size_t moved = 0;
    for (const auto& [set, primitives] : sets) moved += primitives.size();
    bool isFree = moved == users[material];
    for (const auto& [set, primitives] : sets) {
      const int node = materialNodes_[static_cast<std::size_t>(material)];
      const std::string changed = withSet(std::string(json_.raw(node)), set);
      if (isFree) {
        patch_.replace(node, changed);
        isFree = false;
        continue;
      }
      const std::string index = std::to_string(patch_.append(list, changed));
      for (const int primitive : primitives) patch_.set(primitive, "material", index);
    }
  }
}

std::set<int> GltfWriter::setsOfMaterials() const {
  std::set<int> sets;
  for (const GltfRun& run : part_->runs) {
    const int material = primitive(run.primitive).material;
    if (material < 0) continue;
    std::vector<int> textures;
    collectTextures(json_, materialNodes_[static_cast<std::size_t>(material)], textures);
    for (const int texture : textures) sets.insert(setOf(json_, texture));
  }
  return sets;
}

void GltfWriter::tellOrPointMaterials() {
  std::set<int> others = setsOfMaterials();
  const bool usesWritten = others.erase(set_) > 0;
  const bool isReplaced = std::any_of(part_->runs.begin(), part_->runs.end(), [&](const auto& run) {
    return primitive(run.primitive).attribute(semantic(set_)) >= 0;
  });
  if (usesWritten && isReplaced) {
    note("write-set-replaced", {{"set", set_}});
  }
  if (pointsMaterials_ && !others.empty()) return planMaterials();
  std::string list;
  for (const int set : others) list += (list.empty() ? "" : ", ") + semantic(set);
  if (!others.empty()) note("write-set-unused", {{"set", set_}, {"others", list}});
}

}  // namespace hgp::io
