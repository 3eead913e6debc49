// Materials that use another uv set than the one written: a note says so, or they are changed on request.
#include <algorithm>
#include <cmath>
#include <map>

#include "hgp/base/check.h"
#include "hgp/io/gltf/decode/accessor.h"
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

/// The text of a material whose textures use a set instead of others.
std::string withSet(const std::string& material, int set, const std::set<int>& others) {
  const auto own = JsonText::parse(material);
  if (!own) return material;
  std::vector<int> textures;
  collectTextures(*own, JsonText::kRoot, textures);
  JsonPatch changed(*own);
  for (const int texture : textures) {
    if (others.count(setOf(*own, texture)) == 0) continue;
    changed.set(texture, "texCoord", std::to_string(set));
    const int transform = own->find(own->find(texture, "extensions"), kTransform);
    if (own->find(transform, "texCoord") >= 0)
      changed.set(transform, "texCoord", std::to_string(set));
  }
  return changed.text();
}

}  // namespace

/// Records which primitives use their material with the written set instead of `sets`; pointMaterials() carries it out
/// for all meshes.
void GltfWriter::planMaterials(const std::set<int>& sets) {
  for (const GltfRun& run : part_->runs) {
    const int material = primitive(run.primitive).material;
    const std::set<int> own = setsOf(run);
    if (std::none_of(own.begin(), own.end(), [&](int set) { return sets.count(set) > 0; }))
      continue;
    pointed_[material][{set_, sets}].push_back(
        primitiveNodes_[static_cast<std::size_t>(run.primitive)]);
  }
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
    for (const auto& [how, primitives] : sets) moved += primitives.size();
    bool isFree = moved == users[material];
    for (const auto& [how, primitives] : sets) {
      const int node = materialNodes_[static_cast<std::size_t>(material)];
      const std::string changed = withSet(std::string(json_.raw(node)), how.first, how.second);
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

std::set<int> GltfWriter::setsOf(const GltfRun& run) const {
  std::set<int> sets;
  const int material = primitive(run.primitive).material;
  if (material < 0) return sets;
  std::vector<int> textures;
  collectTextures(json_, materialNodes_[static_cast<std::size_t>(material)], textures);
  for (const int texture : textures) sets.insert(setOf(json_, texture));
  return sets;
}

std::set<int> GltfWriter::setsOfMaterials() const {
  std::set<int> sets;
  for (const GltfRun& run : part_->runs) sets.merge(setsOf(run));
  return sets;
}

/// Whether some triangle of a primitive has an area in a set.
bool GltfWriter::hasArea(const GltfRun& run, int set) const {
  const int attribute = primitive(run.primitive).attribute(semantic(set));
  if (attribute < 0) return false;
  const std::vector<double> uv = realNumbers(
      accessor(attribute), packedAttribute(store_, part_->mesh, run.primitive, semantic(set)));
  const int first = part_->pools[static_cast<std::size_t>(run.pool)].firstStored;
  const auto at = [&](int stored) {
    return uv.data() + 2 * static_cast<std::size_t>(stored - first);
  };
  for (int t = run.firstTriangle; t < run.firstTriangle + run.triangleCount; ++t) {
    const auto& corners = part_->stored[static_cast<std::size_t>(t)];
    const double *a = at(corners[0]), *b = at(corners[1]), *c = at(corners[2]);
    const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (std::isfinite(twice) && twice != 0) return true;
  }
  return false;
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
  const auto listed = [&](const std::set<int>& sets) {
    std::string list;
    for (const int set : sets) list += (list.empty() ? "" : ", ") + semantic(set);
    return list;
  };
  if (pointsMaterials_.value_or(false) && !others.empty()) {
    planMaterials(others);
    return note("write-set-used", {{"set", set_}});
  }
  // Those whose material uses the set lack it, or have it without area.
  const auto isUnseen = [&](int set) {
    return std::none_of(part_->runs.begin(), part_->runs.end(), [&](const GltfRun& run) {
      return setsOf(run).count(set) > 0 && hasArea(run, set);
    });
  };
  std::set<int> unseen;
  for (const int set : others)
    if (!pointsMaterials_ && isUnseen(set)) unseen.insert(set);
  if (!unseen.empty()) {
    planMaterials(unseen);
    note("write-set-unseen", {{"set", set_}, {"others", listed(unseen)}});
  }
  for (const int set : unseen) others.erase(set);
  if (!others.empty()) note("write-set-unused", {{"set", set_}, {"others", listed(others)}});
}

}  // namespace hgp::io
