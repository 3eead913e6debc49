#include "hgp/field/cancel_cones.h"
#include "hgp/field/read_holonomy.h"
#include "hgp/field/smooth_field.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {

Result<HolonomySpec> chooseCones(const TriMesh& mesh, const FieldContext& context,
                                 const SuggestOptions& options) {
  if (!report(options.progress, {"field", 0.3})) return cancelled("cones");
  SmoothFieldOptions smooth;
  smooth.q = options.q;
  smooth.alignToCurvature = options.alignToCurvature;
  Result<FrameField> field = smoothField(mesh, context, smooth);
  if (!field) return std::move(field).error();
  const CompleteSpec raw = specOfField(mesh, context, *field);
  PerVertex<int> defect(static_cast<std::size_t>(mesh.vertexCount()), 0);
  for (const ConePoint& cone : raw.cones) defect[cone.vertex] = options.q - cone.k;
  CancelOptions cancel;
  cancel.targetCount = options.coneCount;
  HolonomySpec spec;
  spec.q = options.q;
  spec.cones = cancelCones(mesh, context, options.q, std::move(defect), cancel);
  spec.turning.assign(raw.turning.begin(), raw.turning.end());
  if (Result<BudgetReport> budget = checkPrescription(mesh, context.topology, spec); !budget)
    return std::move(budget).error();
  if (!report(options.progress, {"field", 0.8})) return cancelled("cones");
  return spec;
}

bool isNearlyFlatTorus(const FieldContext& context) {
  if (context.topology.genus != 1 || !context.topology.loops.empty()) return false;
  const std::vector<double>& K = context.surface.curvature;
  Eigen::VectorXd gap = -Eigen::Map<const Eigen::VectorXd>(K.data(), context.surface.nodeCount);
  gap.array() -= gap.mean();
  const Eigen::VectorXd u = context.laplacian.solve(gap);
  return u.maxCoeff() - u.minCoeff() <= kFlatScaleRange;
}

Result<CompleteSpec> suggestCones(PreparedSurface& surface, const SuggestOptions& options,
                                  std::vector<StageTime>* times) {
  std::vector<StageTime> unused;
  StageClock clock(options.progress, times != nullptr ? *times : unused);
  if (!clock.begin("cones")) return cancelled("cones");
  Result<HolonomySpec> spec = chooseCones(surface.mesh(), surface.context(), options);
  if (!spec) return std::move(spec).error();
  if (!clock.begin("connection")) return cancelled("connection");
  if (Status done = surface.requireConnection(); !done) return std::move(done).error();
  if (isNearlyFlatTorus(surface.context())) spec->cones.clear();
  Result<PrescribedField> completed = surface.field(*spec);
  if (!completed) return std::move(completed).error();
  return completed->spec;
}

Result<CompleteSpec> suggestCones(const TriMesh& mesh, const SuggestOptions& options) {
  PreparedSurface surface(mesh);
  return suggestCones(surface, options);
}

Result<CompleteSpec> readHolonomy(const TriMesh& mesh, const FieldData& field,
                                  const std::vector<ConePoint>& expected) {
  Result<FieldContext> context = prepareFields(mesh);
  if (!context) return std::move(context).error();
  return specOfFieldData(mesh, *context, field, expected);
}

}  // namespace hgp
