// Translations of a seamless map made integers.  Role: a grid of unit squares, a tiling texture or a
// quad mesh continues across every seam, on the same triangles and still locally injective.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "hgp/base/progress.h"
#include "hgp/grid/grid_options.h"
#include "hgp/linalg/ordering/ordering.h"
#include "hgp/mesh/mesh_data.h"
#include "hgp/mesh/tri_mesh.h"

namespace hgp {

/// What the caller says of an aligned map.
enum class Acceptance {
  kRefused,
  kSecondChoice,  ///< taken where no other density gives a better one by a linear step
  kAccepted,
};

struct AlignedMap {
  std::optional<UvMap> map;     ///< one unit of uv is one cell
  bool isSecondChoice = false;  ///< the first one of these
  bool isCancelled = false;     ///< by `progress`; there is no map then
  GridReport report;
  double workLeft = 0.0;  ///< multiply-adds, of those that might be spent
};

/// Changes a certified map so that every translation is an integer: the relations of the seam nodes are
/// solved over Z[i], the strain of the change is reduced to what is free, that is rounded nearest first
/// with neighbouring cones kept apart, and the map follows by one linear system. Other densities, cone
/// programs on patches and on the whole mesh follow where triangles turn over.
/// @param map    locally injective and seamless; its copies follow its seams
/// @param cones  vertices with a prescribed angle
/// @param tree   separators of the vertices, or null
/// @param work   multiply-adds that may be spent; what would exceed it is left out, and the reason says so.
///               The linear step is always tried, and small patches have an allowance of their own.
/// @param accepts  asked for every map whose triangles are all positive; without it that is enough
AlignedMap alignToGrid(const TriMesh& mesh, const UvMap& map, int q,
                       const std::vector<VertexId>& cones, const GridOptions& options,
                       const linalg::SeparatorTree* tree, const Progress& progress,
                       double work = std::numeric_limits<double>::infinity(),
                       const std::function<Acceptance(const UvMap&)>& accepts = {});

}  // namespace hgp
