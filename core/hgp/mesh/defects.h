// What stops a triangle soup from being an oriented manifold.  Role: `inspect` and precise refusals.
#pragma once

#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp {

enum class DefectKind {
  kIndexOutOfRange,    ///< a corner names a vertex that does not exist
  kNotFinite,          ///< NaN or infinite position of a used vertex
  kExtent,             ///< larger or smaller than double arithmetic on squares can carry
  kRepeatedVertex,     ///< a face names one vertex twice
  kZeroArea,           ///< a face without area (collinear or equal corners)
  kDuplicateFace,      ///< the same three vertices twice
  kNonManifoldEdge,    ///< an edge with more than two faces
  kInconsistentEdge,   ///< two faces run along an edge in the same direction
  kNonManifoldVertex,  ///< the faces around a vertex form more than one fan
  kIsolatedVertex,     ///< a vertex without faces: kept in the file, left out of the solve
};

/// Short stable name used in JSON ("non-manifold-edge", …).
const char* defectName(DefectKind kind);
/// Isolated vertices are only worth a warning, and so are faces without area where they are allowed
/// (computeGeometry gives them lengths); everything else refuses the mesh.
bool isFatal(DefectKind kind, bool allowsZeroArea = false);

struct Defect {
  DefectKind kind;
  std::vector<Where> where;  ///< every place, in ascending order
};

/// A triangle counts as having no area when its height over the longest edge is below this part of
/// that edge: a few rounding errors of its coordinates. Thinner than healthy is not a defect.
inline constexpr double kZeroHeight = 1e-15;
/// No area in that sense; not-finite corners are another defect and never "no area".
bool hasNoArea(const Vec3& a, const Vec3& b, const Vec3& c);

/// Extents (the longest side of the bounding box of used vertices) that can be worked with.
inline constexpr double kLargestExtent = 1e18, kSmallestExtent = 1e-100;

/// All defects, one entry per kind that occurs, in the order of the enum. O(|F|).
std::vector<Defect> findDefects(const MeshData& data);

/// One sentence for the first fatal defects: "17 edges have more than two faces (first: 3–9, …)".
Status requireUsable(const std::vector<Defect>& defects, bool allowsZeroArea = false);

/// Opt-in repairs of `--fix orient,split,degenerate`.
struct FixOptions {
  bool orient = false;  ///< flip faces so that each orientable component is consistent
  bool split = false;   ///< duplicate vertices until edges and vertices are manifold
  /// Allow faces without area; leave out copies of faces and what is no surface.
  bool degenerate = false;
};

/// Why a face is no part of the surface.
enum class LeftOut {
  kDuplicate,  ///< it has the corners of another face, its twin
  kZeroArea,   ///< it names a vertex twice, or no face of its component has an area
};
struct LeftOutFace {
  int face;  ///< as it was given
  LeftOut why;
  int twin = -1;  ///< of kDuplicate: the face with the same corners that stays
};

struct FixResult {
  MeshData mesh;
  std::vector<int>
      faceOrigin;  ///< new face → old face, with its corners in the same or reverse order
  std::vector<int> vertexOrigin;  ///< new vertex → old vertex
  std::vector<LeftOutFace> leftOut;
  std::vector<std::string> notes;  ///< what was done, with counts
};

/// Applies what is asked. No connection between faces changes but at split vertices, no point moves.
/// In the order degenerate, orient, split. What cannot be repaired stays a
/// defect for findDefects to report (a Möbius band has no orientation).
FixResult fixDefects(const MeshData& data, const FixOptions& options);

}  // namespace hgp
