// The attributes of an OBJ besides its geometry: normals, colours, materials.  Role: read only for conversion
// to another format.
#pragma once

#include <string>
#include <vector>

#include "hgp/io/polygon/obj_text.h"

namespace hgp::io {

struct ObjAttributes {
  std::vector<Vec3> normals;      ///< vn lines in order
  std::vector<int> cornerNormal;  ///< per polygon corner, −1 none; empty when no corner has one
  std::vector<std::array<double, 3>>
      colors;  ///< per vertex, sRGB; white where a v line has none, empty if no line has one
  std::vector<std::string> materials;     ///< names, in order of first use
  std::vector<std::string> libraries;     ///< of mtllib lines, each with its whole line
  std::vector<int> polygonMaterial;       ///< per polygon, −1: none; empty without usemtl
  std::vector<int> polygonSmoothing;      ///< per polygon, 0: off; empty without s lines
  std::vector<std::array<int, 2>> lines;  ///< the edges of l lines, vertices from 0
  int uncolored = 0;                      ///< vertices without a colour, where others have one
  int linesAndPoints = 0;                 ///< l and p lines
  bool hasGroups = false;                 ///< more than one o or g line
};

/// @param places  the result of scanObj for the same text
/// @param cornerCount  number of corners of all polygons together
ObjAttributes readObjAttributes(std::string_view text, const ObjText& places,
                                std::size_t cornerCount);

}  // namespace hgp::io
