// The part of a glTF asset that describes geometry, as plain arrays.  Role: keeps the types of tinygltf out of
// every source but read.cpp.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/io/gltf/json/json.h"

namespace hgp::io {

/// Name of the member of a mesh's extras that contains hgp-cones JSON.
inline constexpr const char* kGltfConesKey = "hgp";
/// The extras of an accessor of uv that hgp wrote, which a later run replaces; the name of the buffer made for them.
inline constexpr const char* kGltfUvExtras = "{\"hgp\":\"uv\"}";
inline constexpr const char* kGltfUvBuffer = "hgp uv";

/// EXT_meshopt_compression or KHR_meshopt_compression of a buffer view.
struct GltfMeshopt {
  int buffer = -1;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0, count = 0;
  std::string mode;    ///< "ATTRIBUTES" "TRIANGLES" "INDICES"
  std::string filter;  ///< "NONE" "OCTAHEDRAL" "QUATERNION" "EXPONENTIAL"
};

struct GltfView {
  int buffer = -1;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0;  ///< 0: tightly packed
  std::optional<GltfMeshopt> meshopt;
};

struct GltfSparse {
  std::uint64_t count = 0;
  int indexView = -1, indexType = 0, valueView = -1;
  std::uint64_t indexOffset = 0, valueOffset = 0;
};

struct GltfAccessor {
  int view = -1;  ///< −1: zeros
  std::uint64_t offset = 0, count = 0;
  int componentType = 0;
  int columns = 1, rows = 1;  ///< VEC3 is one column of three rows
  bool isNormalized = false;
  bool isOwnUv = false;  ///< has kGltfUvExtras
  std::optional<GltfSparse> sparse;

  std::uint64_t componentSize() const;
  /// Bytes of one element; matrix columns start at multiples of 4.
  std::uint64_t elementSize() const;
  int components() const { return columns * rows; }
};

using GltfAttributes = std::map<std::string, int>;

/// KHR_draco_mesh_compression of a primitive.
struct GltfDraco {
  int view = -1;
  GltfAttributes ids;  ///< semantic → unique id inside the Draco data
};

struct GltfPrimitive {
  int mode = 4, indices = -1, material = -1;
  GltfAttributes attributes;
  std::vector<GltfAttributes> targets;
  std::optional<GltfDraco> draco;

  bool isTriangles() const { return mode >= 4 && mode <= 6; }
  int attribute(const std::string& semantic) const {
    const auto found = attributes.find(semantic);
    return found == attributes.end() ? -1 : found->second;
  }
};

/// EXT_mesh_manifold of a mesh.
struct GltfManifold {
  int indices = -1, position = -1, mergeIndices = -1, mergeValues = -1;
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
  std::optional<GltfManifold> manifold;
};

struct GltfModel {
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
};

inline constexpr int kGltfUnsignedByte = 5121, kGltfUnsignedShort = 5123, kGltfUnsignedInt = 5125,
                     kGltfFloat = 5126;

/// Size of a component type in bytes; 0 for a number that is not a component type.
std::uint64_t gltfComponentSize(int componentType);
/// Sets columns and rows from "SCALAR", "VEC3", "MAT4" …; false for anything else.
bool gltfShape(const std::string& type, GltfAccessor& out);

/// Adds the properties stated by the Draco, meshopt and EXT_mesh_manifold extensions, and the index accessors of
/// Draco primitives.
void readGltfExtensions(const JsonText& json, GltfModel& model);

/// Reads the model with tinygltf, which receives only the part of the text that describes geometry: no buffers,
/// images, URIs or extras. Extensions are read from `json`.
/// @pre checkGltf(json) has passed
Result<GltfModel> readGltfModel(const JsonText& json);

}  // namespace hgp::io
