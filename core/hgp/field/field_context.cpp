#include "hgp/field/field_context.h"

#include <utility>

#include "hgp/base/check.h"
#include "hgp/base/parallel.h"

namespace hgp {

FieldContext prepareSurface(const TriMesh& mesh, Metric metric) {
  FieldContext context;
  parallelInvoke({[&] { context.tree = vertexTree(mesh); },
                  [&] { context.topology = computeTopology(mesh); },
                  [&] { context.geometry = computeGeometry(mesh); }});
  HGP_CHECK(context.topology.componentCount == 1, "one component, not %d",
            context.topology.componentCount);
  if (metric == Metric::kEvened)
    context.own = std::exchange(context.geometry, evenedGeometry(mesh));
  context.wideTree = std::make_shared<WideTree>(mesh);
  context.surface = fillBoundary(mesh, context.topology, context.geometry);
  return context;
}

Status prepareConnection(const TriMesh& mesh, FieldContext& context) {
  Result<SurfaceLaplacian> laplacian = SurfaceLaplacian::build(mesh, context.surface, context.tree);
  if (!laplacian) return std::move(laplacian).error();
  context.laplacian = std::move(*laplacian);
  context.handles = computeHandleBasis(mesh, context.surface, context.laplacian);
  return Done{};
}

Result<FieldContext> prepareFields(const TriMesh& mesh) {
  FieldContext context = prepareSurface(mesh);
  if (Status done = prepareConnection(mesh, context); !done) return std::move(done).error();
  return context;
}

}  // namespace hgp
