// Defects: what stops a triangle soup from being an oriented manifold, and the repairs that remove them (their steps
// are in repair/).  Role: `inspect`, messages of meshes that are refused, and `--fix`.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

enum class DefectKind {
  kIndexOutOfRange,  ///< a corner has the index of a vertex that does not exist
  kNotFinite,        ///< NaN or infinite position of a used vertex
  kExtent,  ///< extent outside kSmallestExtent … kLargestExtent: squares over- or underflow
  kRepeatedVertex,     ///< a face has one vertex twice
  kZeroArea,           ///< a face without area (collinear or equal corners)
  kDuplicateFace,      ///< two faces with the same three vertices
  kNonManifoldEdge,    ///< an edge with more than two faces
  kInconsistentEdge,   ///< two faces run along an edge in the same direction
  kNonManifoldVertex,  ///< the faces around a vertex form more than one fan
  kIsolatedVertex,     ///< a vertex without faces: kept in the file, left out of the solve
};

/// Short stable name used in JSON ("non-manifold-edge", …).
const char* defectName(DefectKind kind);
/// Whether a mesh with this defect is refused. Isolated vertices are only a warning, and so are faces without area
/// where they are allowed (computeGeometry gives them lengths).
bool isFatal(DefectKind kind, bool allowsZeroArea = false);

struct Defect {
  DefectKind kind;
  std::vector<Where> where;  ///< every place, in ascending order
};

/// A triangle has no area when its height over the longest edge is below this fraction of
/// that edge: a few rounding errors of its coordinates. Triangles that are merely thin are not a defect.
inline constexpr double kZeroHeight = 1e-15;
/// Whether the triangle has no area in that sense; false if a corner is not finite, which is another defect.
bool hasNoArea(const Vec3& a, const Vec3& b, const Vec3& c);

/// Accepted extents: the longest side of the bounding box of the used vertices, in the mesh's own unit.
inline constexpr double kLargestExtent = 1e18, kSmallestExtent = 1e-100;

/// All defects, one entry per kind that occurs, in the order of the enum. O(|F|).
std::vector<Defect> findDefects(const MeshData& data);

/// The code "defect-…" with count and first places. @param wasRepaired  it is no longer there
Note noteOn(const Defect& defect, bool wasRepaired = false);

/// Fails with kUnsupported and one sentence for the fatal defects: "17 edges have more than two faces (first: 3–9, …)".
/// The advice names the repairs that remove them.
Status requireUsable(const std::vector<Defect>& defects, bool allowsZeroArea = false);

/// Opt-in repairs of `--fix orient,split,degenerate`.
struct FixOptions {
  bool orient = false;  ///< flip faces so that each orientable component is consistent
  bool split = false;   ///< duplicate vertices until edges and vertices are manifold
  /// Allow faces without area; leave out duplicate faces and faces that are not part of a surface.
  bool degenerate = false;
  bool isAny() const { return orient || split || degenerate; }
};

/// Why a face is not part of the surface.
enum class LeftOut {
  kDuplicate,  ///< it has the corners of another face, its twin
  kZeroArea,   ///< it has a vertex twice, or no face of its component has an area
};
struct LeftOutFace {
  int face;  ///< of the mesh as given
  LeftOut why;
  int twin = -1;  ///< of kDuplicate: the face with the same corners that stays
};

struct FixResult {
  MeshData mesh;
  std::vector<int>
      faceOrigin;  ///< new face → old face, with its corners in the same or reverse order
  std::vector<int> vertexOrigin;  ///< new vertex → old vertex
  std::vector<LeftOutFace> leftOut;
  Notes notes;  ///< what was done, with counts
};

/// Applies the chosen repairs in the order degenerate, orient, split. Adjacency of faces changes only at split
/// vertices, and no vertex moves. What cannot be repaired remains a defect that findDefects reports (a Möbius band
/// has no orientation).
FixResult fixDefects(const MeshData& data, const FixOptions& options);

}  // namespace hgp
