// A surface with the data that every format can store.  Role: the intermediate form between two formats; `lost`
// names the content of the source that it cannot represent.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hgp/io/document.h"

namespace hgp::io {

struct PlainSurface {
  std::string name;
  MeshData mesh;
  std::vector<Vec3> normals;                     ///< may be empty
  std::vector<std::array<int, 3>> cornerNormal;  ///< per triangle; −1: none. Empty with `normals`
  std::vector<std::array<double, 4>> colors;  ///< per vertex, linear RGBA in [0, 1]; may be empty
  std::vector<Vec2> uv;                       ///< v up; only for GLB, may be empty
  std::vector<std::array<int, 3>> cornerUv;   ///< per triangle; −1: none. Empty with `uv`
  std::vector<std::string> materials;         ///< names
  std::vector<std::string> libraries;         ///< OBJ: files with these materials
  std::vector<int> triangleMaterial;          ///< per triangle, −1: none; may be empty
  std::vector<int> triangleSmoothing;         ///< group per triangle, 0: none; may be empty
  std::vector<std::array<int, 2>> lines;      ///< edges that the file draws as lines
};

struct PlainFile {
  std::vector<PlainSurface> surfaces;
  Notes lost;  ///< what is not kept; convertFiles() adds the two formats
};

/// The sRGB transfer function and its inverse; colours of OBJ and PLY are sRGB, those of glTF linear.
double linearFromSrgb(double x);
double srgbFromLinear(double x);

/// A GLB with one mesh per surface, without uv. All primitives of a mesh share their vertices, in the order of
/// the surface, so that vertices keep their ids unless two positions become equal in float32.
Bytes plainGlb(const PlainFile& file, const std::string& generator);

/// An OBJ with one object per surface, without vt.
Bytes plainObj(const PlainFile& file, const std::string& generator);

}  // namespace hgp::io
