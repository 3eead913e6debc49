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
/// Isolated vertices are only worth a warning; everything else refuses the mesh.
bool isFatal(DefectKind kind);

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
Status requireUsable(const std::vector<Defect>& defects);

/// Opt-in repairs of `--fix orient,split,degenerate`.
struct FixOptions {
  bool orient = false;  ///< flip faces so that each orientable component is consistent
  bool split = false;   ///< duplicate vertices until edges and vertices are manifold
  bool degenerate =
      false;  ///< remove zero-area, repeated-vertex and duplicate faces, closing the gaps
};

struct FixResult {
  MeshData mesh;
  std::vector<int> faceOrigin;     ///< new face → old face; −1 for a face made by a repair
  std::vector<int> vertexOrigin;   ///< new vertex → old vertex
  std::vector<std::string> notes;  ///< what was done, with counts
};

/// Applies what is asked, in the order degenerate, orient, split. What cannot be repaired stays a
/// defect for findDefects to report (a Möbius band has no orientation).
FixResult fixDefects(const MeshData& data, const FixOptions& options);

}  // namespace hgp
