#include "hgp/mesh/vertex_facts.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/disjoint_sets.h"
#include "hgp/base/ids.h"
#include "hgp/mesh/edge_table.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

std::vector<char> facesWithoutCorners(const MeshData& mesh) {
  const auto count = static_cast<int>(mesh.positions.size());
  std::vector<char> isSkipped(mesh.triangles.size(), 0);
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    const auto& t = mesh.triangles[f];
    isSkipped[f] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0] ||
                   std::any_of(t.begin(), t.end(), [&](int v) { return v < 0 || v >= count; });
  }
  return isSkipped;
}

void addFace(const MeshData& mesh, const std::array<int, 3>& t, VertexFacts& out) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3& p = mesh.positions[at(t[k])];
    const Vec3 a = subtract(mesh.positions[at(t[(k + 1) % 3])], p);
    const Vec3 b = subtract(mesh.positions[at(t[(k + 2) % 3])], p);
    const double twice = norm(cross(a, b));
    out.angle[at(t[k])] += portable::atan2(twice, dot(a, b));
    ++out.valence[at(t[k])];
    if (k == 0 && std::isfinite(twice)) out.area += twice / 2;
  }
}

/// Every edge makes its ends neighbours; counted first, then entered.
void connect(const EdgeTable& edges, VertexFacts& out) {
  std::vector<std::uint32_t>& start = out.neighbourStart;
  for (int e = 0; e < edges.edgeCount(); ++e) {
    for (const int v : edges.vertices(e)) {
      ++start[at(v) + 1];
      if (edges.faceCount(e) == 1) out.isBoundary[at(v)] = 1;
    }
  }
  for (std::size_t v = 1; v < start.size(); ++v) start[v] += start[v - 1];
  out.neighbours.resize(start.back());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (int e = 0; e < edges.edgeCount(); ++e) {
    const auto [v, w] = edges.vertices(e);
    out.neighbours[next[at(v)]++] = static_cast<std::uint32_t>(w);
    out.neighbours[next[at(w)]++] = static_cast<std::uint32_t>(v);
  }
  for (std::size_t v = 0; v + 1 < start.size(); ++v)
    std::sort(out.neighbours.begin() + start[v], out.neighbours.begin() + start[v + 1]);
}

void numberComponents(const MeshData& mesh, const std::vector<char>& isSkipped, VertexFacts& out) {
  DisjointSets sets(static_cast<int>(mesh.positions.size()));
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    if (isSkipped[f] != 0) continue;
    sets.join(mesh.triangles[f][0], mesh.triangles[f][1]);
    sets.join(mesh.triangles[f][0], mesh.triangles[f][2]);
  }
  std::vector<int> number(mesh.positions.size(), -1);
  int count = 0;
  for (std::size_t f = 0; f < isSkipped.size(); ++f) {
    if (isSkipped[f] != 0) continue;
    int& own = number[at(sets.root(mesh.triangles[f][0]))];
    if (own < 0) own = count++;
    for (const int v : mesh.triangles[f]) out.component[at(v)] = own;
  }
}

}  // namespace

VertexFacts vertexFacts(const MeshData& mesh) {
  const std::size_t count = mesh.positions.size();
  VertexFacts out;
  out.angle.assign(count, 0.0);
  out.valence.assign(count, 0);
  out.isBoundary.assign(count, 0);
  out.component.assign(count, -1);
  out.neighbourStart.assign(count + 1, 0);
  const std::vector<char> isSkipped = facesWithoutCorners(mesh);
  for (std::size_t f = 0; f < isSkipped.size(); ++f)
    if (isSkipped[f] == 0) addFace(mesh, mesh.triangles[f], out);
  connect(EdgeTable(mesh.triangles, isSkipped, static_cast<int>(count)), out);
  numberComponents(mesh, isSkipped, out);
  return out;
}

}  // namespace hgp
