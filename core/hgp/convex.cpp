// Tutte/Floater on a disk [BCW17 §3.1, Thm 3.1]: a fixed convex boundary needs no cone program.
#include <Eigen/SparseLU>
#include <chrono>
#include <cmath>

#include "hgp/parametrize.h"
#include "hgp/seamless_setup.h"
#include "hgp/stage_clock.h"

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
    position[mesh.tail(h)] = std::polar(1.0, 2.0 * kPi * walked / total);
    walked += geometry.length[h];
  }
  return position;
}

/// Rows of (7) for interior vertices, boundary values moved to the right-hand side.
bool solveInterior(const TriMesh& mesh, const HarmonicSystem& harmonic,
                   PerVertex<Complex>& position) {
  PerVertex<int> unknown(static_cast<std::size_t>(mesh.vertexCount()), -1);
  int count = 0;
  for (VertexId v : harmonic.rowVertex) unknown[v] = count++;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(count, 2);
  for (int row = 0; row < count; ++row) {
    for (SparseRows::InnerIterator it(harmonic.rows, row); it; ++it) {
      const VertexId v(static_cast<int>(it.col()));
      const double w = it.value().real();
      if (unknown[v] >= 0) {
        entries.emplace_back(row, unknown[v], w);
      } else {
        rhs(row, 0) -= w * position[v].real();
        rhs(row, 1) -= w * position[v].imag();
      }
    }
  }
  if (count == 0) return true;
  Eigen::SparseMatrix<double> L(count, count);
  L.setFromTriplets(entries.begin(), entries.end());
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu(L);
  if (lu.info() != Eigen::Success) return false;
  const Eigen::MatrixXd x = lu.solve(rhs);
  for (VertexId v : harmonic.rowVertex) position[v] = {x(unknown[v], 0), x(unknown[v], 1)};
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

}  // namespace

Result<Parametrization> parametrizeConvex(const TriMesh& mesh, const ParametrizeOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.frames)
    return Failure{ErrorCode::kUsage, "field", "A convex boundary takes no given frames.", {}};
  const Topology topology = computeTopology(mesh);
  if (topology.componentCount != 1 || topology.genus != 0 || topology.loops.size() != 1)
    return Failure{
        ErrorCode::kUnsupported,
        "topology",
        "A convex boundary needs a disk (one component, genus 0, one boundary loop); this "
        "surface has " +
            std::to_string(topology.componentCount) + " components, genus " +
            std::to_string(topology.genus) + " and " + std::to_string(topology.loops.size()) +
            " loops. Leave out --boundary convex to use cones.",
        {}};
  if (!report(options.progress, {"solve", 0.0})) return cancelled("solve");
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
  result.isHarmonic = true;
  Round round;
  round.method = "convex boundary";
  round.solverStatus = "linear";
  round.flipped = result.certificate.orientation.zero + result.certificate.orientation.negative;
  round.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  result.rounds.push_back(round);
  result.times.push_back({"solve", round.seconds});
  return result;
}

}  // namespace hgp
