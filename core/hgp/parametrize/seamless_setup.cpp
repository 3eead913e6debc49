#include "hgp/parametrize/seamless_setup.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/field/given_frames.h"
#include "hgp/mesh/box.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

/// Checks the prescription, completes it and finds its field: ours, or the given one.
Status setUpField(PreparedSurface& surface, const HolonomySpec& spec,
                  const std::optional<FieldData>& frames, SeamlessSetup& setup) {
  const TriMesh& mesh = surface.mesh();
  Result<BudgetReport> budget =
      checkPrescription(mesh, surface.topology(), spec, &surface.shortages());
  if (!budget) return std::move(budget).error();
  HolonomySpec asked = spec;
  std::optional<ReadField> given;
  if (frames) {
    if (Status done = surface.requireConnection(); !done) return done;
    Result<ReadField> read = givenFrames(mesh, surface.context(), *frames, spec);
    if (!read) return std::move(read).error();
    given = std::move(*read);
    asked = toSpec(given->spec);
    budget = checkPrescription(mesh, surface.topology(), asked, &surface.shortages());
    if (!budget) return std::move(budget).error();
  }
  setup.warnings = budget->warnings;
  setup.isTooCoarse = budget->isTooCoarse;
  Result<PrescribedField> field = surface.field(asked);
  if (!field) return std::move(field).error();
  setup.field = std::move(*field);
  if (!given) return Done{};
  HGP_CHECK(setup.field.spec.turning == given->spec.turning &&
                setup.field.spec.handles == given->spec.handles,
            "given frames have the holonomy of the connection that weighs them");
  setup.field.field = std::move(given->field);
  return Done{};
}

}  // namespace

Result<SeamlessSetup> prepareSeamless(PreparedSurface& surface, const HolonomySpec& spec,
                                      const ParametrizeOptions& options,
                                      std::vector<StageTime>& times) {
  const TriMesh& mesh = surface.mesh();
  StageClock clock(options.progress, times);
  SeamlessSetup setup;
  setup.context = surface.share();
  if (!clock.begin(Stage::kField)) return clock.cancelled();
  if (Status done = setUpField(surface, spec, options.frames, setup); !done)
    return std::move(done).error();
  if (mesh.faceCount() > PreparedSurface::kKeptFaces) surface.releaseConnection();
  for (const ConePoint& cone : setup.field.spec.cones) setup.cones.push_back(cone.vertex);

  if (!clock.begin(Stage::kCut)) return clock.cancelled();
  cutOpen(mesh, setup);

  if (!clock.begin(Stage::kAssemble)) return clock.cancelled();
  assemble(mesh, setup);
  clock.end();
  return setup;
}

void cutOpen(const TriMesh& mesh, SeamlessSetup& setup) {
  const FieldContext& context = *setup.context;
  setup.cut =
      cutToDisk(mesh, seamGraph(mesh, context.geometry, context.surface, setup.cones), setup.cones);
  HGP_CHECK(isDisk(mesh, setup.cut), "the cut surface is a disk");
  setup.seams = seamRotations(mesh, setup.cut, setup.field.field);
}

void assemble(const TriMesh& mesh, SeamlessSetup& setup) {
  setup.unknowns = reduceUnknowns(mesh, setup.cut, setup.seams);
  setup.harmonic = harmonicSystem(mesh, setup.context->geometry, setup.cut, setup.unknowns,
                                  setup.seams.q, setup.cones);
}

UvMap layOut(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
             const std::vector<Complex>& z) {
  UvMap map;
  map.cornerUv.resize(static_cast<std::size_t>(mesh.faceCount()));
  double area = 0.0, surface = 0.0;
  for (FaceId f : mesh.faces()) {
    auto& corners = map.cornerUv[static_cast<std::size_t>(f.i)];
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = cut.copy[TriMesh::halfedge(f, k)].i;
    surface += geometry.area[f] * geometry.unit * geometry.unit;
    if (z.empty()) continue;
    const auto at = [&](std::size_t k) { return z[static_cast<std::size_t>(corners[k])]; };
    area += 0.5 * std::imag(std::conj(at(1) - at(0)) * (at(2) - at(0)));
  }
  map.uv.assign(static_cast<std::size_t>(cut.vertexCount()), Vec2{0.0, 0.0});
  if (z.empty()) return map;
  double scale = area > 0.0 ? std::sqrt(surface / area) : 1.0;
  if (!std::isfinite(scale)) scale = 1.0;
  Box<2> box;
  for (const Complex& p : z) box.add({p.real(), p.imag()});
  const Complex centre(0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]));
  for (std::size_t c = 0; c < z.size(); ++c) {
    const Complex p = scale * (z[c] - centre);
    map.uv[c] = {p.real(), p.imag()};
  }
  return map;
}

UvMap layOut(const TriMesh& mesh, const SeamlessSetup& setup, const std::vector<Complex>& z) {
  return layOut(mesh, setup.context->ownGeometry(), setup.cut, z);
}

}  // namespace hgp
