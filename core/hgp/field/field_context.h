// The data that every field of one surface is computed from.  Role: computed once per surface.
#pragma once

#include <memory>
#include <optional>

#include "hgp/base/result.h"
#include "hgp/field/filled_surface.h"
#include "hgp/field/handle_basis.h"
#include "hgp/field/mesh_trees.h"
#include "hgp/field/surface_laplacian.h"

namespace hgp {

/// Where lengths and angles come from.
enum class Metric : unsigned char {
  kOwn,    ///< computeGeometry
  kEvened  ///< evenedGeometry
};

/// A smooth field needs all but the Laplacian and the handles; a prescribed one needs everything.
struct FieldContext {
  Topology topology;
  Geometry geometry;
  std::optional<Geometry> own;  ///< the surface's own, where `geometry` is another metric's
  linalg::SeparatorTree tree;   ///< of the vertices
  FilledSurface surface;
  SurfaceLaplacian laplacian;
  HandleBasis handles;
  std::shared_ptr<WideTree> wideTree = {};  ///< with separators of width 2

  const Geometry& ownGeometry() const { return own ? *own : geometry; }
};
/// All but the Laplacian and the handles, which take most of the memory.
FieldContext prepareSurface(const TriMesh& mesh, Metric metric = Metric::kOwn);
/// Adds what prepareSurface leaves out.
Status prepareConnection(const TriMesh& mesh, FieldContext& context);
/// Both at once.
Result<FieldContext> prepareFields(const TriMesh& mesh);

}  // namespace hgp
