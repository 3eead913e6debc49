// Attributes of new vertices that are means of stored ones.  Role: what quads and split triangles take from a glTF, for every
// kind of accessor.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hgp/io/blend.h"
#include "hgp/io/gltf/decode/weld.h"

namespace hgp::io {

/// An attribute of a mesh by the vertices that have it.
struct GltfAttributeOf {
  std::string semantic;
  int target = -1;             ///< morph target; −1: the base shape
  std::vector<int> primitive;  ///< by pool: one that has it, −1 if none does
};

/// Elements with the stride of their size rounded up to 4.
struct GltfBlended {
  Bytes data;
  std::uint64_t stride = 0;
  int componentType = 0;
  bool isNormalized = false;
};

class GltfBlender {
 public:
  /// @param vertices  blends of stored vertices, each of one pool
  GltfBlender(const GltfStore& store, const GltfSurface& part, const std::vector<Blend>& vertices);

  /// Float and normalized integers are interpolated, normals and tangents brought to length 1. JOINTS and WEIGHTS are those of
  /// all corners together, the largest ones, with the same sum. Integers with a name of their own (`_ID`) are those of the
  /// nearest corner. Positions, other integers and what differs in type between pools become float.
  /// Vertices whose pool has no such attribute get one that is valid. Fails with kUnsupported where pools have elements of
  /// different sizes.
  Result<GltfBlended> blend(const GltfAttributeOf& attribute) const;
  /// The same of given positions.
  static GltfBlended positions(const std::vector<Vec3>& positions);

 private:
  using Numbers = std::vector<double>;
  const GltfAccessor& shapeOf(const GltfAttributeOf& attribute, std::size_t pool) const;
  /// Of every pool that has the attribute.
  std::vector<Numbers> numbersOf(const GltfAttributeOf& attribute) const;
  void interpolate(const GltfAttributeOf& attribute, std::size_t width, Numbers& out) const;
  using Skin = std::vector<std::array<Numbers, 2>>;
  Skin skinOf(int primitive) const;
  static void takeBones(const Blend& blend, const Skin& skin, int firstStored, std::size_t set,
                        bool areJoints, double* x);
  bool takeSkin(const GltfAttributeOf& attribute, Numbers& out) const;
  std::size_t poolOf(int stored) const;

  const GltfStore& store_;
  const GltfSurface& part_;
  const std::vector<Blend>& vertices_;
};

}  // namespace hgp::io
