#include "hgp/verify/asked_map.h"

#include <algorithm>

#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/turns.h"

namespace hgp {
namespace {

Where placeOf(VertexId v) { return {Where::Kind::kVertex, v.i}; }

Reason mismatch(std::string message, std::vector<Where> where = {}) {
  const int count = std::max<int>(1, static_cast<int>(where.size()));
  return {Rule::kPrescription, count, 0.0, std::move(message), std::move(where)};
}

void takeFeatures(const TriMesh& mesh, const HolonomySpec& asked, AskedMap& out) {
  int missing = 0;
  for (EdgeId e : asked.features) {
    if (e.i >= 0 && e.i < mesh.edgeCount())
      out.features.push_back(e);
    else
      ++missing;
  }
  if (missing > 0)
    out.mismatches.push_back(mismatch(
        formatText("%d feature%s no edge of the mesh.", missing, missing == 1 ? " is" : "s are")));
}

/// A loop with a corner has no others: its other vertices are straight.
void takeCorners(const TriMesh& mesh, const Topology& topology, const HolonomySpec& asked,
                 AskedMap& out) {
  PerVertex<int>& k = out.angles.k;
  for (VertexId v : mesh.vertices())
    if (mesh.isBoundary(v)) k[v] = 0;
  std::vector<Where> strays;
  for (const ConePoint& c : asked.corners) {
    const bool isThere = c.vertex.i >= 0 && c.vertex.i < mesh.vertexCount();
    if (!isThere || !mesh.isBoundary(c.vertex) || k[c.vertex] != 0 || c.k < 1 || asked.q % 2 != 0)
      strays.push_back(placeOf(c.vertex));
    else
      k[c.vertex] = c.k;
  }
  if (!strays.empty())
    out.mismatches.push_back(
        mismatch(formatText("%zu corner%s given twice, without an angle, with an odd q or not at a "
                            "boundary vertex.",
                            strays.size(), strays.size() == 1 ? " is" : "s are"),
                 strays));
  for (const BoundaryLoop& loop : topology.loops) {
    const auto hasCorner = [&](HalfedgeId h) { return k[mesh.tail(h)] != 0; };
    if (std::none_of(loop.halfedges.begin(), loop.halfedges.end(), hasCorner)) continue;
    for (HalfedgeId h : loop.halfedges)
      if (k[mesh.tail(h)] == 0) k[mesh.tail(h)] = asked.q / 2;
  }
}

}  // namespace

AskedMap layOutAsked(const TriMesh& mesh, const Topology& topology, int handleCount,
                     const HolonomySpec& asked, const CertifyOptions& options) {
  AskedMap out;
  const auto vertexCount = static_cast<std::size_t>(mesh.vertexCount());
  out.angles.q = asked.q;
  out.angles.k = PerVertex<int>(vertexCount, asked.q);
  out.angles.isCone = PerVertex<char>(vertexCount, 0);
  out.angles.isAnyConeAllowed = options.isAnyConeAllowed;
  if (asked.q < 1) {
    out.mismatches.push_back(
        mismatch(formatText("q = %d; the order must be at least 1.", asked.q)));
    return out;
  }
  std::vector<Where> strays;
  for (const ConePoint& c : asked.cones) {
    const bool isThere = c.vertex.i >= 0 && c.vertex.i < mesh.vertexCount();
    if (!isThere || mesh.isIsolated(c.vertex) || mesh.isBoundary(c.vertex) ||
        out.angles.isCone[c.vertex]) {
      strays.push_back(placeOf(c.vertex));
      continue;
    }
    out.angles.isCone[c.vertex] = 1;
    out.angles.k[c.vertex] = c.k;
  }
  if (!strays.empty())
    out.mismatches.push_back(
        mismatch(formatText("%zu cone%s given twice or not at an interior vertex.", strays.size(),
                            strays.size() == 1 ? " is" : "s are"),
                 strays));
  takeCorners(mesh, topology, asked, out);
  if (asked.turning.size() == topology.loops.size()) {
    out.angles.turning = asked.turning;
  } else if (!asked.turning.empty()) {
    out.mismatches.push_back(
        mismatch(formatText("%zu turning indices are given for %s.", asked.turning.size(),
                            counted(topology.loops.size(), "boundary loop").c_str())));
  }
  if (asked.handles.size() == static_cast<std::size_t>(handleCount)) {
    out.handles = asked.handles;
    for (auto& r : out.handles)
      if (r) r = reduceTurn(*r, asked.q);
  } else if (!asked.handles.empty()) {
    out.mismatches.push_back(mismatch(formatText(
        "%zu handle rotations are given for %d generators.", asked.handles.size(), handleCount)));
  }
  takeFeatures(mesh, asked, out);
  return out;
}

}  // namespace hgp
