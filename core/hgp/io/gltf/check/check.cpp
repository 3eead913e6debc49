#include "hgp/io/gltf/check/check.h"

#include <algorithm>
#include <array>

#include "hgp/base/check.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

/// Extensions that a file may require: they are decoded here, or do not affect geometry.
constexpr std::array kKnownExtensions = {std::string_view("KHR_draco_mesh_compression"),
                                         std::string_view("EXT_meshopt_compression"),
                                         std::string_view("KHR_meshopt_compression"),
                                         std::string_view("KHR_mesh_quantization"),
                                         std::string_view("EXT_mesh_manifold"),
                                         std::string_view("EXT_mesh_gpu_instancing"),
                                         std::string_view("KHR_texture_basisu"),
                                         std::string_view("KHR_texture_transform"),
                                         std::string_view("EXT_texture_webp"),
                                         std::string_view("EXT_texture_avif"),
                                         std::string_view("MSFT_texture_dds"),
                                         std::string_view("KHR_lights_punctual"),
                                         std::string_view("KHR_animation_pointer"),
                                         std::string_view("KHR_node_visibility"),
                                         std::string_view("KHR_xmp_json_ld"),
                                         std::string_view("EXT_lights_image_based"),
                                         std::string_view("MSFT_lod")};

bool isKnownExtension(std::string_view name) {
  return name.substr(0, 14) == "KHR_materials_" ||
         std::find(kKnownExtensions.begin(), kKnownExtensions.end(), name) !=
             kKnownExtensions.end();
}

/// Where the text has an index and which array it refers to. [] = every element, {} = every member.
struct Reference {
  const char* path;
  const char* target;
};
constexpr Reference kReferences[] = {
    {"scene", "scenes"},
    {"scenes/[]/nodes/[]", "nodes"},
    {"nodes/[]/camera", "cameras"},
    {"nodes/[]/children/[]", "nodes"},
    {"nodes/[]/mesh", "meshes"},
    {"nodes/[]/skin", "skins"},
    {"nodes/[]/extensions/EXT_mesh_gpu_instancing/attributes/{}", "accessors"},
    {"skins/[]/inverseBindMatrices", "accessors"},
    {"skins/[]/skeleton", "nodes"},
    {"skins/[]/joints/[]", "nodes"},
    {"animations/[]/channels/[]/target/node", "nodes"},
    {"animations/[]/samplers/[]/input", "accessors"},
    {"animations/[]/samplers/[]/output", "accessors"},
    {"images/[]/bufferView", "bufferViews"},
    {"textures/[]/sampler", "samplers"},
    {"textures/[]/source", "images"},
    {"materials/[]/normalTexture/index", "textures"},
    {"materials/[]/occlusionTexture/index", "textures"},
    {"materials/[]/emissiveTexture/index", "textures"},
    {"materials/[]/pbrMetallicRoughness/baseColorTexture/index", "textures"},
    {"materials/[]/pbrMetallicRoughness/metallicRoughnessTexture/index", "textures"},
    {"bufferViews/[]/buffer", "buffers"},
    {"bufferViews/[]/extensions/EXT_meshopt_compression/buffer", "buffers"},
    {"bufferViews/[]/extensions/KHR_meshopt_compression/buffer", "buffers"},
    {"accessors/[]/bufferView", "bufferViews"},
    {"accessors/[]/sparse/indices/bufferView", "bufferViews"},
    {"accessors/[]/sparse/values/bufferView", "bufferViews"},
    {"meshes/[]/primitives/[]/attributes/{}", "accessors"},
    {"meshes/[]/primitives/[]/indices", "accessors"},
    {"meshes/[]/primitives/[]/material", "materials"},
    {"meshes/[]/primitives/[]/targets/[]/{}", "accessors"},
    {"meshes/[]/primitives/[]/extensions/KHR_draco_mesh_compression/bufferView", "bufferViews"},
    {"meshes/[]/extensions/EXT_mesh_manifold/manifoldPrimitive/indices", "accessors"},
    {"meshes/[]/extensions/EXT_mesh_manifold/manifoldPrimitive/attributes/{}", "accessors"},
    {"meshes/[]/extensions/EXT_mesh_manifold/mergeIndices", "accessors"},
    {"meshes/[]/extensions/EXT_mesh_manifold/mergeValues", "accessors"},
};

/// Calls visit(node) for every value at the end of `path`; missing steps end a branch.
template <class Visit>
void walkPath(const JsonText& json, int node, std::string_view path, const Visit& visit) {
  if (path.empty()) {
    visit(node);
    return;
  }
  const std::size_t slash = std::min(path.find('/'), path.size());
  const std::string_view step = path.substr(0, slash);
  const std::string_view rest = path.substr(std::min(slash + 1, path.size()));
  if (step == "[]" || step == "{}") {
    for (int c = json.firstChild(node); c >= 0; c = json.node(c).next) {
      walkPath(json, c, rest, visit);
    }
    return;
  }
  const int member = json.find(node, step);
  if (member >= 0) walkPath(json, member, rest, visit);
}

/// "2.0" as {2, 0}; empty for text that is not a version.
std::optional<std::array<int, 2>> version(const std::string& text) {
  const std::size_t dot = text.find('.');
  if (dot == 0 || dot == std::string::npos || dot + 1 == text.size() || text.size() > 9) {
    return std::nullopt;
  }
  std::array<int, 2> out{};
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == dot) continue;
    if (!text::isDigit(text[i])) return std::nullopt;
    int& part = out[i > dot ? 1 : 0];
    part = part * 10 + (text[i] - '0');
  }
  return out;
}

}  // namespace

Status checkGltf(const JsonText& json, const Limits& limits) {
  return GltfChecker(json, limits).run();
}

std::vector<int> gltfReferences(const JsonText& json, std::string_view target) {
  std::vector<int> out;
  for (const Reference& reference : kReferences) {
    if (target != reference.target) continue;
    walkPath(json, JsonText::kRoot, reference.path, [&](int node) { out.push_back(node); });
  }
  return out;
}

bool areGltfReferencesKnown(const JsonText& json) {
  // Nodes are in the order of the text, so the subtree of an extras can be skipped as one range.
  const int count = json.size();
  for (int i = 1; i < count; ++i) {
    const bool isMember = json.node(i).keyEnd > json.node(i).keyBegin;
    if (!isMember) continue;
    const std::string key = json.key(i);
    if (key == "extras") {
      const std::uint32_t end = json.node(i).end;
      while (i + 1 < count && json.node(i + 1).begin < end) ++i;
    } else if (key == "extensions") {
      for (int extension : json.children(i)) {
        if (!isKnownExtension(json.key(extension))) return false;
      }
    }
  }
  return true;
}

Status GltfChecker::run() {
  if (!json_.isObject(JsonText::kRoot)) {
    fail(JsonText::kRoot, "the JSON text of a glTF file must be an object");
    return *failure_;
  }
  bool isGood = checkAsset() && checkExtensionNames() && checkReferences();
  const auto list = [&](const char* name) {
    return json_.children(json_.find(JsonText::kRoot, name));
  };
  if (isGood) {
    buffers_ = list("buffers");
    views_ = list("bufferViews");
    accessors_ = list("accessors");
    meshes_ = list("meshes");
    nodes_ = list("nodes");
    isGood = checkBuffers();
  }
  for (std::size_t i = 0; isGood && i < views_.size(); ++i) isGood = checkView(views_[i]);
  for (std::size_t i = 0; isGood && i < accessors_.size(); ++i) {
    isGood = checkAccessor(accessors_[i]);
  }
  for (std::size_t i = 0; isGood && i < meshes_.size(); ++i) isGood = checkMesh(meshes_[i]);
  isGood = isGood && checkNodes();
  if (!isGood) return *failure_;
  return Done{};
}

bool GltfChecker::fail(int node, const std::string& message, ErrorCode code) {
  if (failure_) return false;
  const std::string pointer = json_.pointer(node);
  failure_ = Failure{code, "read", (pointer.empty() ? "glTF" : pointer) + ": " + message, {}};
  if (code == ErrorCode::kLimit) failure_->advice = {Note("raise-bytes")};
  if (node >= 0) failure_->where.push_back({Where::Kind::kByte, json_.node(node).begin});
  return false;
}

bool GltfChecker::integer(int object, const char* key, std::int64_t fallback, std::int64_t& out) {
  const int member = json_.find(object, key);
  if (member < 0) {
    out = fallback;
    return fallback >= 0 || fail(object, formatText("'%s' is missing", key));
  }
  const auto value = json_.integer(member);
  if (!value || *value < 0) {
    return fail(member, "must be a non-negative integer, not " + text::inQuotes(json_.raw(member)));
  }
  out = *value;
  return true;
}

int GltfChecker::element(const char* array, int referenceNode) const {
  const auto index = json_.integer(referenceNode);
  if (!index) return -1;
  const std::string_view name = array;
  const std::vector<int>& list = name == "accessors"     ? accessors_
                                 : name == "bufferViews" ? views_
                                                         : buffers_;
  return list[static_cast<std::size_t>(*index)];
}

bool GltfChecker::checkAsset() {
  const int asset = json_.find(JsonText::kRoot, "asset");
  if (!json_.isObject(asset)) return fail(JsonText::kRoot, "'asset' is missing: not a glTF file");
  const int versionNode = json_.find(asset, "version");
  const auto have = version(json_.string(versionNode));
  if (!have) return fail(asset, "'version' is missing or is not \"2.x\"");
  if ((*have)[0] != 2) {
    return fail(versionNode, "glTF version " + text::inQuotes(json_.string(versionNode)) +
                                 " is not supported, only 2.x; export the file as glTF 2.0");
  }
  const int minimum = json_.find(asset, "minVersion");
  if (minimum < 0) return true;
  const auto wanted = version(json_.string(minimum));
  if (!wanted) return fail(minimum, "must be a version such as \"2.0\"");
  if (*wanted > std::array<int, 2>{2, 0}) {
    return fail(minimum, "needs a reader of glTF " + text::inQuotes(json_.string(minimum)) +
                             ", this one reads 2.0; export the file as glTF 2.0");
  }
  return true;
}

bool GltfChecker::checkExtensionNames() {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    const int array = json_.find(JsonText::kRoot, list);
    if (array < 0) continue;
    if (!json_.isArray(array)) return fail(array, "must be an array");
    for (int name : json_.children(array)) {
      if (!json_.isString(name)) return fail(name, "must be a string");
      if (std::string_view(list) == "extensionsRequired" && !isKnownExtension(json_.string(name))) {
        return fail(name,
                    "the file requires the extension " + text::inQuotes(json_.string(name), 80) +
                        ", which this reader does not know; export it without this extension");
      }
    }
  }
  return true;
}

bool GltfChecker::checkReferences() {
  for (const char* name :
       {"scenes", "nodes", "meshes", "accessors", "bufferViews", "buffers", "materials", "textures",
        "images", "samplers", "skins", "cameras", "animations"}) {
    const int list = json_.find(JsonText::kRoot, name);
    if (list >= 0 && !json_.isArray(list)) return fail(list, "must be an array");
  }
  for (const Reference& reference : kReferences) {
    if (!checkReference(JsonText::kRoot, reference.path, reference.target)) return false;
  }
  return true;
}

bool GltfChecker::checkReference(int node, std::string_view path, const char* target) {
  if (path.empty()) {
    const auto index = json_.integer(node);
    if (!index || *index < 0) {
      return fail(
          node, "must be an index, a non-negative integer, not " + text::inQuotes(json_.raw(node)));
    }
    const int array = json_.find(JsonText::kRoot, target);
    const int count = json_.isArray(array) ? json_.node(array).count : 0;
    if (*index < count) return true;
    return fail(node, formatText("refers to %s[%lld], but there are %d", target,
                                 static_cast<long long>(*index), count));
  }
  const std::size_t slash = std::min(path.find('/'), path.size());
  const std::string_view step = path.substr(0, slash);
  const std::string_view rest = path.substr(std::min(slash + 1, path.size()));
  if (step == "[]" || step == "{}") {
    const bool isArray = step == "[]";
    if (!json_.isKind(node, isArray ? JsonKind::kArray : JsonKind::kObject)) {
      return fail(node, isArray ? "must be an array" : "must be an object");
    }
    for (int c = json_.firstChild(node); c >= 0; c = json_.node(c).next) {
      if (!checkReference(c, rest, target)) return false;
    }
    return true;
  }
  if (!json_.isObject(node)) return fail(node, "must be an object");
  const int member = json_.find(node, step);
  return member < 0 || checkReference(member, rest, target);
}

}  // namespace hgp::io
