// Meshes, primitives and the node tree.
#include "hgp/base/check.h"
#include "hgp/io/gltf/check/check.h"
#include "hgp/io/gltf/json/model.h"
#include "hgp/io/limits.h"
#include "hgp/text/text.h"

namespace hgp::io {
namespace {

constexpr int kDeepestNode = 1000;

bool isOneOf(std::int64_t value, std::initializer_list<std::int64_t> list) {
  for (std::int64_t candidate : list) {
    if (candidate == value) return true;
  }
  return false;
}

}  // namespace

bool GltfChecker::checkMesh(int mesh) {
  if (!json_.isObject(mesh)) return fail(mesh, "must be an object");
  const int name = json_.find(mesh, "name");
  if (name >= 0 && !json_.isString(name)) return fail(name, "must be a string");
  const int primitives = json_.find(mesh, "primitives");
  if (!json_.isArray(primitives) || json_.node(primitives).count == 0) {
    return fail(mesh, "'primitives' must be a non-empty array");
  }
  for (int c = json_.firstChild(primitives); c >= 0; c = json_.node(c).next) {
    if (!checkPrimitive(c)) return false;
  }
  return true;
}

bool GltfChecker::checkPrimitive(int primitive) {
  if (!json_.isObject(primitive)) return fail(primitive, "must be an object");
  std::int64_t mode = 4, vertexCount = -1, corners = 0;
  if (!integer(primitive, "mode", 4, mode)) return false;
  if (mode > 6) return fail(json_.find(primitive, "mode"), "must be from 0 to 6");
  const int attributes = json_.find(primitive, "attributes");
  if (!json_.isObject(attributes)) return fail(primitive, "'attributes' must be an object");
  if (!checkVertexAttributes(attributes, vertexCount, false)) return false;
  for (int target : json_.children(json_.find(primitive, "targets"))) {
    if (!checkVertexAttributes(target, vertexCount, true)) return false;
  }
  corners = vertexCount < 0 ? 0 : vertexCount;
  if (!checkIndices(primitive, corners) || !checkDraco(primitive)) return false;
  if (mode < 4) return true;
  triangles_ += static_cast<std::uint64_t>(mode == 4 ? corners / 3 : corners);
  if (triangles_ <= limits_.maxTriangles) return true;
  fail(primitive, "more than " + triangleLimit(limits_.maxTriangles), ErrorCode::kLimit);
  failure_->advice = {Note("raise-triangles")};
  return false;
}

bool GltfChecker::checkVertexAttributes(int attributes, std::int64_t& count, bool isTarget) {
  for (int member : json_.children(attributes)) {
    const int accessor = element("accessors", member);
    std::int64_t own = 0, componentType = 0;
    if (!integer(accessor, "count", -1, own) ||
        !integer(accessor, "componentType", -1, componentType)) {
      return false;
    }
    if (count >= 0 && own != count) {
      return fail(member, formatText("has %lld elements where the other attributes have %lld",
                                     static_cast<long long>(own), static_cast<long long>(count)));
    }
    count = own;
    const std::string type = json_.string(json_.find(accessor, "type"));
    const std::string semantic = json_.key(member);
    if (semantic == "POSITION" && type != "VEC3") {
      return fail(member, "POSITION must be VEC3, not " + text::inQuotes(type));
    }
    if (semantic.rfind("TEXCOORD_", 0) == 0 && !isTarget && type != "VEC2") {
      return fail(member,
                  text::inQuotes(semantic, 40) + " must be VEC2, not " + text::inQuotes(type));
    }
    if (semantic == "POSITION" && !isOneOf(componentType, {5120, 5121, 5122, 5123, 5126})) {
      return fail(member, "POSITION cannot have 32-bit integers");
    }
  }
  return true;
}

bool GltfChecker::checkIndices(int primitive, std::int64_t& count) {
  const int reference = json_.find(primitive, "indices");
  if (reference < 0) return true;
  const int accessor = element("accessors", reference);
  std::int64_t componentType = 0;
  if (!integer(accessor, "count", -1, count) ||
      !integer(accessor, "componentType", -1, componentType)) {
    return false;
  }
  const bool isScalar = json_.string(json_.find(accessor, "type")) == "SCALAR";
  if (isScalar && isOneOf(componentType, {5121, 5123, 5125}) &&
      !json_.isTrue(json_.find(accessor, "normalized"))) {
    return true;
  }
  return fail(reference, "indices must be SCALAR, unsigned and not normalized");
}

bool GltfChecker::checkDraco(int primitive) {
  const int extension =
      json_.find(json_.find(primitive, "extensions"), "KHR_draco_mesh_compression");
  if (extension < 0) return true;
  if (json_.find(extension, "bufferView") < 0) return fail(extension, "'bufferView' is missing");
  const int ids = json_.find(extension, "attributes");
  if (!json_.isObject(ids)) return fail(extension, "'attributes' must be an object");
  if (json_.find(primitive, "indices") < 0) {
    return fail(primitive, "a Draco primitive needs 'indices'");
  }
  const int attributes = json_.find(primitive, "attributes");
  for (int member : json_.children(ids)) {
    const auto id = json_.integer(member);
    if (!id || *id < 0 || *id > INT32_MAX) {
      return fail(member,
                  "must be a non-negative integer, not " + text::inQuotes(json_.raw(member)));
    }
    if (json_.find(attributes, json_.key(member)) < 0) {
      return fail(member, "is an attribute that the primitive does not have");
    }
  }
  return true;
}

bool GltfChecker::checkNodes() {
  const std::size_t count = nodes_.size();
  std::vector<int> parent(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    for (int child : json_.children(json_.find(nodes_[i], "children"))) {
      const auto index = static_cast<std::size_t>(*json_.integer(child));
      if (parent[index] >= 0 || index == i) {
        return fail(child, formatText("node %zu has two parents or is its own parent", index));
      }
      parent[index] = static_cast<int>(i);
    }
  }
  // Every node has at most one parent, so the nodes that no root reaches form cycles.
  std::vector<std::pair<int, int>> open;
  for (std::size_t i = 0; i < count; ++i) {
    if (parent[i] < 0) open.emplace_back(static_cast<int>(i), 1);
  }
  std::size_t reached = 0;
  while (!open.empty()) {
    const auto [index, depth] = open.back();
    open.pop_back();
    ++reached;
    const int node = nodes_[static_cast<std::size_t>(index)];
    if (depth > kDeepestNode) {
      return fail(node, formatText("nodes nested deeper than %d", kDeepestNode));
    }
    for (int child : json_.children(json_.find(node, "children"))) {
      open.emplace_back(static_cast<int>(*json_.integer(child)), depth + 1);
    }
  }
  if (reached == count) return true;
  return fail(json_.find(JsonText::kRoot, "nodes"), "some nodes are their own ancestors");
}

}  // namespace hgp::io
