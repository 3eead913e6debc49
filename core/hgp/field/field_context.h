// What every field of one surface is computed from.  Role: found once per surface.
#pragma once

#include "hgp/base/result.h"
#include "hgp/field/filled_surface.h"
#include "hgp/field/handle_basis.h"
#include "hgp/field/surface_laplacian.h"
#include "hgp/linalg/ordering/ordering.h"

namespace hgp {

/// What every field of one surface is computed from; build once per surface. A smooth field needs
/// the first four; a prescribed one all.
struct FieldContext {
  Topology topology;
  Geometry geometry;
  linalg::SeparatorTree tree;  ///< of the vertices
  FilledSurface surface;
  SurfaceLaplacian laplacian;
  HandleBasis handles;
};
/// All but the Laplacian and the handles, which take most of the memory.
FieldContext prepareSurface(const TriMesh& mesh);
/// Adds what prepareSurface leaves out.
Status prepareConnection(const TriMesh& mesh, FieldContext& context);
/// Both at once.
Result<FieldContext> prepareFields(const TriMesh& mesh);

}  // namespace hgp
