// Tutte/Floater on a disk [BCW17 §3.1, Thm 3.1]: a fixed convex boundary needs no cone program.
#include <chrono>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/field/mesh_trees.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/parametrize/parametrize.h"
#include "hgp/parametrize/seamless_setup.h"
#include "hgp/parametrize/stage_clock.h"
#include "hgp/system/row_builder.h"

namespace hgp {
namespace {

/// Boundary vertices on the unit circle by arc length; each polygon corner is strictly convex.
PerVertex<Complex> circlePositions(const TriMesh& mesh, const Geometry& geometry,
                                   const BoundaryLoop& loop) {
  double total = 0.0;
  for (HalfedgeId h : loop.halfedges) total += geometry.length[h];
  PerVertex<Complex> position(static_cast<std::size_t>(mesh.vertexCount()));
  double walked = 0.0;
  for (HalfedgeId h : loop.halfedges) {
    position[mesh.tail(h)] = portable::polar(1.0, 2.0 * kPi * walked / total);
    walked += geometry.length[h];
  }
  return position;
}

/// Solves the rows of (7) for interior vertices. The contribution of the boundary to a row is a coefficient of one more
/// unknown, fixed at 1, which is the only one that the elimination keeps.
bool solveInterior(const TriMesh& mesh, const HarmonicSystem& harmonic,
                   PerVertex<Complex>& position) {
  PerVertex<int> unknown(static_cast<std::size_t>(mesh.vertexCount()), -1);
  int boundary = 0;
  for (VertexId v : harmonic.rowVertex) unknown[v] = boundary++;
  RowBuilder builder(boundary + 1, boundary + 1,
                     static_cast<std::size_t>(harmonic.rows.nonZeros()));
  for (int row = 0; row < boundary; ++row) {
    for (SparseRows::InnerIterator it(harmonic.rows, row); it; ++it) {
      const VertexId v(static_cast<int>(it.col()));
      if (unknown[v] >= 0)
        builder.add(unknown[v], it.value());
      else
        builder.add(boundary, it.value() * position[v]);
    }
    builder.endRow(0.0);
  }
  builder.endRow(0.0);
  linalg::SeparatorTree tree = linalg::restrictTree(vertexTree(mesh), unknown.raw());
  tree.order.push_back(boundary);
  tree.nodeStart.back() = boundary + 1;
  linalg::SchurLu lu;
  if (!lu.build(builder.take(), {boundary}, tree)) return false;
  const Eigen::MatrixXcd x = lu.extend(Eigen::MatrixXcd::Ones(1, 1));
  for (VertexId v : harmonic.rowVertex) position[v] = x(unknown[v], 0);
  return true;
}

/// Without seams every vertex has one copy and one unknown, itself.
HarmonicSystem plainHarmonicSystem(const TriMesh& mesh, const Geometry& geometry,
                                   const CutMesh& cut) {
  ReducedUnknowns identity;
  identity.count = mesh.vertexCount();
  identity.copies.resize(cut.vertexCount(), mesh.vertexCount());
  identity.turn = PerCutVertex<int>(static_cast<std::size_t>(cut.vertexCount()), 0);
  for (int c = 0; c < cut.vertexCount(); ++c)
    identity.copies.insert(c, cut.parent[CutVertexId(c)].i) = 1.0;
  return harmonicSystem(mesh, geometry, cut, identity, 1, {});
}

Status requireDisk(const Topology& topology, const ParametrizeOptions& options) {
  if (options.frames)
    return Failure{
        ErrorCode::kUsage, "field", "A convex boundary cannot be combined with given frames.", {}};
  if (options.improve)
    return Failure{ErrorCode::kUsage,
                   "improve",
                   "A convex boundary would not stay convex in an improvement. Leave out the "
                   "convex boundary to have less distortion.",
                   {}};
  if (topology.componentCount != 1 || topology.genus != 0 || topology.loops.size() != 1)
    return Failure{
        ErrorCode::kUnsupported,
        "topology",
        "A convex boundary needs a disk (one component, genus 0, one boundary loop); this "
        "surface has " +
            std::to_string(topology.componentCount) + " components, genus " +
            std::to_string(topology.genus) + " and " + std::to_string(topology.loops.size()) +
            " loops.",
        {},
        {Note("use-cones")}};
  return Done{};
}

}  // namespace

Result<Parametrization> parametrizeConvex(const TriMesh& mesh, const ParametrizeOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Topology topology = computeTopology(mesh);
  if (Status fits = requireDisk(topology, options); !fits) return fits.error();
  if (!report(options.progress, {Stage::kSolve, 0.0})) return cancelled(Stage::kSolve);
  const Geometry geometry = computeGeometry(mesh);
  const CutMesh cut =
      cutToDisk(mesh, PerEdge<char>(static_cast<std::size_t>(mesh.edgeCount()), 0), {});
  PerVertex<Complex> position = circlePositions(mesh, geometry, topology.loops[0]);
  if (!solveInterior(mesh, plainHarmonicSystem(mesh, geometry, cut), position))
    return Failure{ErrorCode::kUnsupported,
                   "solve",
                   "The harmonic system of this disk is singular: its geometry is not numerically "
                   "usable.",
                   {}};

  Parametrization result;
  std::vector<Complex> z(static_cast<std::size_t>(cut.vertexCount()));
  for (int c = 0; c < cut.vertexCount(); ++c)
    z[static_cast<std::size_t>(c)] = position[cut.parent[CutVertexId(c)]];
  result.map = layOut(mesh, geometry, cut, z);
  result.copyOf = cut.parent.raw();
  result.spec.turning = {result.spec.q};
  result.certificate = certify(mesh, result.spec, result.map);
  result.isCertified = result.certificate.isCertified;
  result.isUsable = result.certificate.isUsable;
  Round round;
  round.method = "convex boundary";
  round.solverStatus = "linear";
  round.flipped = result.certificate.orientation.zero + result.certificate.orientation.negative;
  round.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.rounds.push_back(round);
  result.times.push_back({Stage::kSolve, round.seconds});
  return result;
}

}  // namespace hgp
