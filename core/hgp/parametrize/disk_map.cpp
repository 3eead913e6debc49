#include "hgp/cut/cut_mesh.h"
#include "hgp/field/filled_surface.h"
#include "hgp/parametrize/parametrize.h"

namespace hgp {
namespace {

/// The ends of the cut of a sphere, which has no terminals: two vertices that are far apart.
std::vector<VertexId> farEnds(const TriMesh& mesh) {
  VertexId first = mesh.tail(HalfedgeId{0}), last = first;
  for (int sweep = 0; sweep < 2; ++sweep) {
    double farthest = -1.0;
    for (VertexId v : mesh.vertices()) {
      if (mesh.isIsolated(v)) continue;
      double square = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double d = mesh.position(v)[i] - mesh.position(first)[i];
        square += d * d;
      }
      if (v == first || !(square > farthest)) continue;
      farthest = square;
      last = v;
    }
    if (sweep == 0) std::swap(first, last);
  }
  return {first, last};
}

}  // namespace

Result<UvMap> cutDiskMap(const TriMesh& mesh, const ParametrizeOptions& options) {
  const Topology topology = computeTopology(mesh);
  const Geometry geometry = computeGeometry(mesh);
  std::vector<VertexId> ends;
  if (topology.genus == 0 && topology.loops.empty()) ends = farEnds(mesh);
  const CutMesh cut = cutToDisk(
      mesh, seamGraph(mesh, geometry, fillBoundary(mesh, topology, geometry), ends), ends);
  MeshData open;
  for (int c = 0; c < cut.vertexCount(); ++c)
    open.positions.push_back(mesh.position(cut.parent[CutVertexId(c)]));
  for (FaceId f : mesh.faces()) {
    auto& corners = open.triangles.emplace_back();
    for (int k = 0; k < 3; ++k)
      corners[static_cast<std::size_t>(k)] = cut.copy[TriMesh::halfedge(f, k)].i;
  }
  const Result<TriMesh> disk = buildTriMesh(open, true);
  if (!disk) return disk.error();
  ParametrizeOptions plain;
  plain.progress = options.progress;
  Result<Parametrization> run = parametrizeConvex(*disk, plain);
  if (!run) return run.error();
  return std::move(run->map);
}

}  // namespace hgp
