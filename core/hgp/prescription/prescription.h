// What a file asks of a map, before it meets a mesh.  Role: q, C, k_i, l_j and holonomy of [BCW17
// §5.2] as cone files and field files spell them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hgp/base/result.h"
#include "hgp/mesh/field_data.h"
#include "hgp/mesh/mesh_data.h"

namespace hgp::io {

/// Cone angle 2πk/q at a vertex; `position` is what tells vertices apart when the mesh has changed.
/// Where the surface touches itself at a vertex, it is a vertex of several parts: `triangle` is one of
/// the part that is meant, or −1.
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

/// Raw ids, nothing checked against a mesh. Where `field` is there it decides everything the lists
/// leave open; stored matchings must be realised.
struct Prescription {
  int q = 4;
  bool hasCones = false;  ///< the list of cones is complete (it may be empty)
  std::vector<PrescribedCone> cones;
  std::vector<PrescribedTurning> boundaries;
  std::vector<PrescribedHandle> handles;
  std::optional<FieldData> field;
  /// Total angle per vertex in radians (`_Th_hat`), reduced by reduceTotalAngles; otherwise empty.
  std::vector<double> totalAngles;
  int vertexCount = -1;  ///< of the mesh it was made for; −1 unknown
  int triangleCount = -1;
  std::string sha256;              ///< of the file it was made for, or ""
  std::vector<std::string> notes;  ///< what was read, and what was reduced
};

}  // namespace hgp::io
