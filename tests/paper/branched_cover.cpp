#include "paper/branched_cover.h"

#include <map>
#include <numeric>

#include "hgp/base/check.h"
#include "support/shapes.h"

namespace hgp::test {
namespace {

int rootOf(std::vector<int>& parent, int a) {
  while (parent[static_cast<std::size_t>(a)] != a) {
    int& above = parent[static_cast<std::size_t>(a)];
    above = parent[static_cast<std::size_t>(above)];
    a = above;
  }
  return a;
}

int signChanges(const std::vector<double>& values) {
  int changes = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    changes += (values[i] > 0) != (values[(i + 1) % values.size()] > 0);
  return changes;
}

}  // namespace

BranchedCover branchedCover(const TriMesh& mesh, const SeamRotations& seams) {
  const int q = seams.q, halfedges = mesh.halfedgeCount();
  BranchedCover cover;
  cover.sheets = q;
  // Corners of all sheets, joined across every edge: seam edge h of sheet n is parallel to its twin
  // on sheet n − r, since the twin's vector is e^{i2πr/q} times its own.
  std::vector<int> corner(static_cast<std::size_t>(q * halfedges));
  std::iota(corner.begin(), corner.end(), 0);
  const auto join = [&](int a, int b) {
    a = rootOf(corner, a);
    b = rootOf(corner, b);
    corner[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
  };
  for (int n = 0; n < q; ++n) {
    for (HalfedgeId h : mesh.halfedges()) {
      const HalfedgeId twin = mesh.twin(h);
      if (!twin.isValid()) continue;
      const int other = reduceTurn(n - seams.rotation[h], q);
      join(n * halfedges + h.i, other * halfedges + TriMesh::next(twin).i);
      join(n * halfedges + TriMesh::next(h).i, other * halfedges + twin.i);
    }
  }
  std::map<int, int> vertexOf;
  MeshData data;
  for (int n = 0; n < q; ++n) {
    for (FaceId f : mesh.faces()) {
      std::array<int, 3> triangle{};
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = TriMesh::halfedge(f, k);
        const auto [at, isNew] = vertexOf.try_emplace(rootOf(corner, n * halfedges + h.i),
                                                      static_cast<int>(data.positions.size()));
        if (isNew) {
          data.positions.push_back(mesh.position(mesh.tail(h)));
          cover.projection.push_back(mesh.tail(h));
        }
        triangle[static_cast<std::size_t>(k)] = at->second;
      }
      data.triangles.push_back(triangle);
    }
  }
  cover.mesh = meshOf(data);
  cover.topology = computeTopology(cover.mesh);
  PerHalfedge<LoopId> loopOf(static_cast<std::size_t>(halfedges));
  const Topology base = computeTopology(mesh);
  for (std::size_t j = 0; j < base.loops.size(); ++j)
    for (HalfedgeId h : base.loops[j].halfedges) loopOf[h] = LoopId(static_cast<int>(j));
  for (const BoundaryLoop& loop : cover.topology.loops)
    cover.loopProjection.push_back(loopOf[HalfedgeId(loop.halfedges[0].i % halfedges)]);
  return cover;
}

std::vector<Complex> liftedEdges(const BranchedCover& cover, const CutMesh& cut,
                                 const std::vector<Complex>& z) {
  const int halfedges = cover.mesh.halfedgeCount() / cover.sheets;
  std::vector<Complex> edges;
  for (int n = 0; n < cover.sheets; ++n)
    for (int h = 0; h < halfedges; ++h) {
      const auto at = [&](HalfedgeId g) { return z[static_cast<std::size_t>(cut.copy[g].i)]; };
      edges.push_back(rotation(n, cover.sheets) *
                      (at(TriMesh::next(HalfedgeId(h))) - at(HalfedgeId(h))));
    }
  return edges;
}

int Indices::sum() const {
  int total = 0;
  for (const auto* list : {&vertex, &face, &exterior})
    total = std::accumulate(list->begin(), list->end(), total);
  return total;
}

Indices countIndices(const BranchedCover& cover, const std::vector<Complex>& edges, double alpha,
                     double beta) {
  const TriMesh& mesh = cover.mesh;
  // One value per edge, so that both sides agree to the last bit.
  const auto form = [&](HalfedgeId h) {
    const HalfedgeId own = mesh.halfedge(mesh.edge(h));
    const Complex d = edges[static_cast<std::size_t>(own.i)];
    const double value = alpha * d.real() + beta * d.imag();
    return own == h ? value : -value;
  };
  const auto indexOf = [](const std::vector<double>& around) {
    const int changes = signChanges(around);
    HGP_CHECK(changes % 2 == 0, "sign changes around a cycle are even");
    return 1 - changes / 2;
  };
  Indices indices;
  for (VertexId v : mesh.vertices()) {
    std::vector<double> around;
    HalfedgeId last;
    for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
      around.push_back(form(h));
      last = h;
    }
    // A boundary vertex has one more edge, the one that its last face ends at.
    if (mesh.isBoundary(v)) around.push_back(-form(TriMesh::previous(last)));
    indices.vertex.push_back(indexOf(around));
  }
  for (FaceId f : mesh.faces())
    indices.face.push_back(indexOf({form(TriMesh::halfedge(f, 0)), form(TriMesh::halfedge(f, 1)),
                                    form(TriMesh::halfedge(f, 2))}));
  for (const BoundaryLoop& loop : cover.topology.loops) {
    std::vector<double> around;
    for (HalfedgeId h : loop.halfedges) around.push_back(form(h));
    indices.exterior.push_back(indexOf(around));
  }
  return indices;
}

}  // namespace hgp::test
