// Makes the translations of a seamless map integers.  Role: a grid of unit squares, a tiling texture or a
// quad mesh then continues across every seam; the triangles stay the same and the map locally injective.
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

/// The caller's verdict on an aligned map.
enum class Acceptance {
  kRefused,
  kSecondChoice,  ///< used if no other density gives an accepted map by a linear step
  kAccepted,
};

struct Verdict {
  Acceptance acceptance = Acceptance::kAccepted;
  double added = 0.0;  ///< quads that the quad mesh of the map has beyond its cells
  // NOLINTNEXTLINE(google-explicit-constructor): most callers have nothing to add
  Verdict(Acceptance a, double more = 0.0) : acceptance(a), added(more) {}
};

struct AlignedMap {
  std::optional<UvMap> map;  ///< one unit of uv is one cell
  bool isSecondChoice =
      false;  ///< `map` is one for which `accepts` said kSecondChoice or whose cells are far off
  bool isCancelled = false;  ///< by `progress`; there is no map then
  GridReport report;
  double multiplyAddsLeft = 0.0;  ///< of those that might be spent
};

/// Changes a certified map so that every translation is an integer. The relations of the seam nodes are
/// solved over Z[i]; the strain energy of the change is reduced to the free integers; these are rounded one by
/// one so that neighbouring cones stay apart; the map then follows from one linear system. Where triangles
/// flip, cone programs on patches and on the whole mesh follow, and then other densities. For quads the density is
/// corrected so that the rounded map has the number of cells that was asked for; maps whose quads are more than a tenth
/// off are second choices, too, and the nearest of them is taken.
/// @param map    locally injective and seamless; its copies follow its seams
/// @param cones  vertices with a prescribed angle
/// @param tree   separators of the vertices, or null
/// @param work   multiply-adds that may be spent; steps that would exceed it are skipped, and the report's reason says
///               so. The linear step is always tried, and small patches have a separate budget.
/// @param accepts  called for every map whose triangles are all positive; if empty, all of them are accepted
AlignedMap alignToGrid(const TriMesh& mesh, const UvMap& map, int q,
                       const std::vector<VertexId>& cones, const GridOptions& options,
                       const linalg::SeparatorTree* tree, const Progress& progress,
                       double work = std::numeric_limits<double>::infinity(),
                       const std::function<Verdict(const UvMap&)>& accepts = {});

}  // namespace hgp
