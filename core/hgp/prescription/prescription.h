// What a file prescribes, before it is resolved on a mesh.  Role: q, C, k_i, l_j and holonomy of [BCW17 §5.2] as in
// cone files and field files.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/mesh/field_data.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::prescription {

/// Cone angle 2πk/q at a vertex; `position` identifies the vertex if the mesh has changed.
/// If several fans of triangles meet at the vertex, `triangle` is a triangle of the fan that is meant; −1 otherwise.
struct PrescribedCone {
  int vertex = -1;
  int k = 0;
  std::optional<Vec3> position;
  int triangle = -1;
};

/// Turning angle 2πl/q of boundary loop `loop` of the mesh; `anchor` is a vertex on it, or −1.
struct PrescribedTurning {
  int loop = -1;
  int l = 0;
  int anchor = -1;
};

/// Rotation r ∈ Z_q along handle generator `generator`.
struct PrescribedHandle {
  int generator = -1;
  int r = 0;
};

/// A polyline of feature edges. `positions`, empty or one per vertex, identify the vertices if the mesh has changed.
struct PrescribedLine {
  std::vector<int> vertices;
  std::vector<Vec3> positions = {};
};

/// How a file itself marks edges.
enum class FeatureMark {
  kLines,      ///< OBJ l lines
  kSmoothing,  ///< between groups of OBJ s lines
  kMaterials,  ///< between materials
  kNormals,    ///< where corners of two triangles have different normals
};
inline constexpr const char* kFeatureMarks[] = {"lines", "smoothing", "materials", "normals"};
/// The marks that these words name, all for none; empty where a word is none of kFeatureMarks.
std::optional<std::vector<FeatureMark>> featureMarksNamed(const std::vector<std::string>& words);

/// Edges that a map is to send to lines u = const or v = const, exactly. With any feature, boundary edges are features.
struct PrescribedFeatures {
  bool hasRims = false;  ///< the boundary edges, also where there is no other feature
  std::optional<double> creaseDegrees;  ///< inner edges with a larger dihedral angle (findCreases)
  std::vector<FeatureMark> marks;       ///< what the mesh's own file marks in these ways
  std::vector<PrescribedLine> lines;
  std::vector<std::array<int, 2>> sides;  ///< triangle and side: side k joins corners k and k + 1
  std::string
      sha256;  ///< of the file for which lines and sides were listed; "": that of the prescription
  bool isEmpty() const {
    return !hasRims && !creaseDegrees && marks.empty() && lines.empty() && sides.empty();
  }
};

/// Ids as in the file, not checked against a mesh. If there is a `field`, it determines everything that the lists
/// leave open; stored matchings must be realised.
struct Prescription {
  int q = 4;
  bool hasCones = false;  ///< the list of cones is complete (it may be empty)
  std::vector<PrescribedCone> cones;
  std::vector<PrescribedTurning> boundaries;
  std::vector<PrescribedHandle> handles;
  std::optional<FieldData> field;
  PrescribedFeatures features = {};
  /// Total angle per vertex in radians (`_Th_hat`), reduced by reduceTotalAngles; otherwise empty.
  std::vector<double> totalAngles;
  int vertexCount = -1;  ///< of the mesh it was made for; −1 unknown
  int triangleCount = -1;
  std::string sha256;  ///< of the file it was made for, or ""
  Notes notes;         ///< for users: what was read and reduced
};

}  // namespace hgp::prescription
