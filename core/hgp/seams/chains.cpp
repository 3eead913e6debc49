#include "hgp/seams/chains.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

/// The other seam edge at the head of h, leaving it.
HalfedgeId continuedChain(const TriMesh& mesh, const PerEdge<char>& isSeam, HalfedgeId h) {
  for (HalfedgeId out : outgoingHalfedges(mesh, mesh.head(h)))
    if (isSeam[mesh.edge(out)] && mesh.edge(out) != mesh.edge(h)) return out;
  return {};
}

void traceFrom(const TriMesh& mesh, const PerEdge<char>& isSeam, VertexId node, SeamChains& out) {
  for (HalfedgeId first : outgoingHalfedges(mesh, node)) {
    if (!isSeam[mesh.edge(first)] || out.chain[first] >= 0) continue;
    SeamChain chain;
    for (HalfedgeId h = first;; h = continuedChain(mesh, isSeam, h)) {
      HGP_CHECK(h.isValid(), "a seam chain ends only at a node");
      chain.left.push_back(h);
      out.chain[h] = out.chain[mesh.twin(h)] = out.chainCount();
      out.isLeft[h] = 1;
      if (out.isSeamNode[mesh.head(h)]) break;
    }
    out.chains.push_back(std::move(chain));
  }
}

}  // namespace

PerVertex<char> seamNodes(const TriMesh& mesh, const PerEdge<char>& isSeam,
                          const std::vector<VertexId>& cones) {
  PerVertex<int> degree(at(mesh.vertexCount()), 0);
  for (EdgeId e : mesh.edges()) {
    if (!isSeam[e]) continue;
    ++degree[mesh.tail(mesh.halfedge(e))];
    ++degree[mesh.head(mesh.halfedge(e))];
  }
  PerVertex<char> isNode(at(mesh.vertexCount()), 0);
  for (VertexId v : cones) isNode[v] = degree[v] > 0;
  for (VertexId v : mesh.vertices())
    if (degree[v] > 0 && (degree[v] != 2 || mesh.isBoundary(v))) isNode[v] = 1;
  return isNode;
}

SeamChains traceChains(const TriMesh& mesh, const PerEdge<char>& isSeam, PerVertex<char> isNode) {
  SeamChains out;
  out.chain = PerHalfedge<int>(at(mesh.halfedgeCount()), -1);
  out.isLeft = PerHalfedge<char>(at(mesh.halfedgeCount()), 0);
  out.isSeamNode = std::move(isNode);
  for (VertexId v : mesh.vertices())
    if (out.isSeamNode[v]) traceFrom(mesh, isSeam, v, out);
  for (EdgeId e : mesh.edges()) {
    if (!isSeam[e] || out.chain[mesh.halfedge(e)] >= 0) continue;
    const VertexId node = mesh.tail(mesh.halfedge(e));
    out.isSeamNode[node] = 1;
    traceFrom(mesh, isSeam, node, out);
  }
  return out;
}

std::vector<int> chainsOfEdges(const TriMesh& mesh, const std::vector<EdgeId>& edges,
                               const std::vector<int>& turn, int q) {
  PerEdge<char> isSeam(at(mesh.edgeCount()), 0);
  for (EdgeId e : edges) isSeam[e] = 1;
  PerVertex<char> isNode = seamNodes(mesh, isSeam, {});
  PerVertex<int> turnAt(at(mesh.vertexCount()), -1);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const int own = std::min(turn[i], reduceTurn(-turn[i], q));
    const HalfedgeId h = mesh.halfedge(edges[i]);
    for (VertexId v : {mesh.tail(h), mesh.head(h)}) {
      if (turnAt[v] >= 0 && turnAt[v] != own) isNode[v] = 1;
      turnAt[v] = own;
    }
  }
  const SeamChains traced = traceChains(mesh, isSeam, std::move(isNode));
  std::vector<int> number(traced.chains.size(), -1), out;
  int count = 0;
  for (EdgeId e : edges) {
    int& own = number[at(traced.chain[mesh.halfedge(e)])];
    if (own < 0) own = count++;
    out.push_back(own);
  }
  return out;
}

HalfedgeId firstOfSectors(const TriMesh& mesh, const PerEdge<char>& isSeam, VertexId v) {
  if (!mesh.isBoundary(v))
    for (HalfedgeId h : outgoingHalfedges(mesh, v))
      if (isSeam[mesh.edge(h)]) return h;
  return mesh.outgoing(v);
}

}  // namespace hgp
