#include "hgp/parametrize/along/straight_setup.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/features/cone_scale.h"
#include "hgp/features/field_along.h"
#include "hgp/features/fitted_field.h"
#include "hgp/optimize/lone_cones.h"
#include "hgp/parametrize/stage_clock.h"

namespace hgp {
namespace {

constexpr double kQuarter = kPi / 2.0;

/// Headings of features in the combed field. Of the two sides of an edge one is enough: the matching across it follows
/// from both axes.
void findEdges(const TriMesh& mesh, const std::vector<EdgeId>& features, StraightSetup& setup) {
  const FrameField& field = setup.aligned.field;
  for (EdgeId e : features) {
    const HalfedgeId h = mesh.halfedge(e);
    const FaceId f = TriMesh::face(h);
    const double combed = (setup.seamless.seams.frameAngle[f] - field.angle[f]) / kQuarter;
    setup.edges.push_back({h, reduceTurn(setup.aligned.axis[h] - std::lround(combed), field.q)});
  }
}

std::vector<FaceId> baseFaces(const TriMesh& mesh, const StraightSetup& setup) {
  const Sectors& sectors = setup.aligned.sectors;
  PerVertex<char> isCone(at(mesh.vertexCount()), 0);
  for (VertexId v : setup.seamless.cones) isCone[v] = !sectors.isOnFeature[v];
  std::vector<FaceId> faces;
  for (FaceId f : mesh.faces()) {
    bool isBase = false;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const bool isReflex =
          sectors.of[h] >= 0 && setup.aligned.index[at(sectors.node(mesh, h))] >= 3;
      isBase = isBase || isReflex || isCone[mesh.tail(h)];
    }
    if (isBase) faces.push_back(f);
  }
  return faces;
}

Status equate(const TriMesh& mesh, StraightSetup& setup) {
  const SeamlessSetup& seamless = setup.seamless;
  std::vector<char> isShared(at(seamless.unknowns.count), 1);
  for (VertexId v : mesh.vertices())
    if (seamless.unknowns.vertexUnknown[v] >= 0)
      isShared[at(seamless.unknowns.vertexUnknown[v])] = 0;
  std::vector<EqualCoordinate> equations;
  for (const StraightEdge& e : setup.edges)
    equations.push_back(
        {seamless.cut.copy[e.h].i, seamless.cut.copy[TriMesh::next(e.h)].i, e.heading % 2 == 0});
  std::optional<RealUnknowns> unknowns =
      equateCoordinates(seamless.unknowns.copies, isShared, equations);
  if (!unknowns)
    return Failure{ErrorCode::kUnsupported,
                   "features",
                   "The equations of these features have no exact solution in halves; leave out "
                   "some of them.",
                   {}};
  setup.unknowns = std::move(*unknowns);
  return Done{};
}

}  // namespace

Result<StraightSetup> prepareLengths(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                     AlignedField aligned, const ParametrizeOptions& options,
                                     std::vector<StageTime>& times) {
  const TriMesh& mesh = surface.mesh();
  StageClock clock(options.progress, times);
  StraightSetup setup;
  SeamlessSetup& seamless = setup.seamless;
  seamless.context = surface.share();
  const FieldContext& context = *seamless.context;
  setup.aligned = std::move(aligned);
  PrescribedField& field = seamless.field;
  field.spec = specOf(mesh, context.topology, handleGenerators(mesh), setup.aligned, features);
  field.field = setup.aligned.field;
  for (const ConePoint& cone : field.spec.cones) seamless.cones.push_back(cone.vertex);
  Result<BudgetReport> budget =
      checkPrescription(mesh, context.topology, toSpec(field.spec), &surface.shortages());
  if (!budget) return std::move(budget).error();
  seamless.warnings = budget->warnings;
  seamless.isTooCoarse = budget->isTooCoarse;

  if (!clock.begin(Stage::kCut)) return clock.cancelled();
  seamless.cut = cutToDisk(mesh, seamGraph(mesh, context.geometry, context.surface, seamless.cones),
                           seamless.cones);
  HGP_CHECK(isDisk(mesh, seamless.cut), "the cut surface is a disk");
  seamless.seams = seamRotations(mesh, seamless.cut, field.field);

  if (!clock.begin(Stage::kAssemble)) return clock.cancelled();
  seamless.unknowns = reduceUnknowns(mesh, seamless.cut, seamless.seams);
  findEdges(mesh, features, setup);
  if (Status done = equate(mesh, setup); !done) return std::move(done).error();
  setup.hasRow = PerVertex<char>(at(mesh.vertexCount()), 1);
  for (VertexId v : mesh.vertices())
    if (mesh.isIsolated(v) || setup.aligned.sectors.isOnFeature[v]) setup.hasRow[v] = 0;
  for (VertexId v : seamless.cones) setup.hasRow[v] = 0;
  setup.base = baseFaces(mesh, setup);
  setup.distances =
      distancesOfLoneCones(systemOf(mesh, seamless), setup.unknowns, setup.edges, setup.aligned);
  clock.end();
  return setup;
}

void completeStraight(const TriMesh& mesh, StraightSetup& setup) {
  PrescribedField& field = setup.seamless.field;
  if (!setup.aligned.isFitted) {
    // The turns of the field stay, and with them the rotations of seams and the headings of features.
    fitField(mesh, setup.seamless.context->geometry, setup.aligned);
    field.field = setup.aligned.field;
    setup.seamless.seams = seamRotations(mesh, setup.seamless.cut, field.field);
  }
  if (field.u.size() > 0) return;
  field.u = coneScale(mesh, *setup.seamless.context, setup.aligned);
  const auto [low, high] = std::minmax_element(field.u.begin(), field.u.end());
  field.scaleRange = *high - *low;
}

Result<StraightSetup> prepareLengths(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                     const HolonomySpec& asked, const ParametrizeOptions& options,
                                     std::vector<StageTime>& times) {
  StageClock clock(options.progress, times);
  if (!clock.begin(Stage::kField)) return clock.cancelled();
  Result<AlignedField> aligned = alignedField(surface.mesh(), surface.context(), features, asked);
  if (!aligned) return std::move(aligned).error();
  clock.end();
  return prepareLengths(surface, features, std::move(*aligned), options, times);
}

Result<StraightSetup> prepareStraight(PreparedSurface& surface, const std::vector<EdgeId>& features,
                                      const HolonomySpec& asked, const ParametrizeOptions& options,
                                      std::vector<StageTime>& times) {
  Result<StraightSetup> setup = prepareLengths(surface, features, asked, options, times);
  if (setup) completeStraight(surface.mesh(), *setup);
  return setup;
}

}  // namespace hgp
