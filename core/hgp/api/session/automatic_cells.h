// How many cells a grid has when nobody says.  Role: the density of `hgp quads` without --cells; the page takes the
// same.
#pragma once

#include "hgp/api/model/model.h"
#include "hgp/api/request/request.h"
#include "hgp/parametrize/parametrization.h"

namespace hgp::api {

/// 14 cells along the diagonal of the model, at least 800, and at least 40 per prescribed cone: fewer cells fail more
/// often and cause more distortion. With several meshes in the file these have one edge length (cell_lengths.h), which is
/// halved for a mesh until it has 200 cells, and 40 per prescribed cone.
/// @param conesAlong  cones of fields along features: 20 cells for each. They are many and at corners; with fewer cells lines
///                    are spread to keep apart
double automaticCells(const Model& model, const Request& request, int conesAlong);

/// Whether a run needs no other cones for its grid, because nobody gave the number of cells: it is aligned with whatever number, or
/// one that works with these cones is known, with which the run is made again. Other cones cost a run each. Of several components, all must have one spacing.
bool isAnyNumberGood(const Model& model, const SolveOptions& options,
                     const Result<Parametrization>& run);

}  // namespace hgp::api
