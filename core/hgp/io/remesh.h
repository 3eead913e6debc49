// New polygons on the triangles of a surface, and what they take from it.  Role: quads and split triangles keep the attributes
// of the mesh that they replace.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "hgp/io/blend.h"
#include "hgp/io/plain_surface.h"
#include "hgp/io/polygons.h"
#include "hgp/io/written.h"

namespace hgp::io {

/// The point Σ weight[k] · corner k of a triangle of the surface.
struct FacePoint {
  int triangle = -1;
  std::array<double, 3> weight{};
};

struct Remesh {
  PolygonMesh polygons;
  std::vector<Vec3> normals;  ///< of the surface's shape, per vertex; may be empty
  std::vector<FacePoint> at;  ///< per corner of a polygon: the point whose attributes it has
  std::vector<int> triangle;  ///< per polygon: the triangle whose material it has
};

/// What OBJ and PLY can store of polygons.
struct PolygonAttributes {
  std::vector<Vec2> uv;       ///< v up
  std::vector<int> cornerUv;  ///< per corner, −1: none; empty without uv
  std::vector<Vec3> normals;
  std::vector<int> cornerNormal;  ///< likewise
  std::vector<std::array<double, 4>>
      colors;  ///< per vertex, sRGB and opacity in [0, 1]; may be empty
  std::vector<std::string> materials, libraries;
  std::vector<int> polygonMaterial;  ///< −1: none; may be empty
};

/// Those of a surface at the corners of new polygons; normals have length 1, and are those of the shape where the surface has
/// none.
/// @param uv  of the surface, or null
/// @param areLinear  whether colours are mixed as linear light, as in glTF, or as sRGB, as they are stored in OBJ and PLY
PolygonAttributes attributesAt(const PlainSurface& surface, const UvMap* uv, bool areLinear,
                               const Remesh& remesh);

/// Polygons as OBJ, sorted by material, with 17 digits for positions and uv.
Bytes polygonsAsObj(const PolygonMesh& polygons, const PolygonAttributes& attributes,
                    const std::string& comment);
/// Polygons as text PLY: normals and colours per vertex, uv per corner of a face (`texcoord`). Without materials.
Bytes polygonsAsPly(const PolygonMesh& polygons, const PolygonAttributes& attributes,
                    const std::string& comment);
/// Polygons cut into fans of triangles, as one mesh of a GLB.
Bytes polygonsAsGlb(const PolygonMesh& polygons, const PolygonAttributes& attributes,
                    const std::string& generator);

}  // namespace hgp::io
