// The copies of a vertex at seams, in terms of its first copy and of the chains' translations.  Role: (12) of [BCW17]
// composed around a vertex, once and exactly, over a ring that contains the rotations.
#pragma once

#include <optional>
#include <vector>

#include "hgp/seams/chains.h"
#include "hgp/seams/cyclotomic.h"
#include "hgp/seams/eisenstein.h"
#include "hgp/seams/gaussian.h"

namespace hgp {

template <class Ring>
struct RingTerm {
  int variable = 0;
  Ring factor;
};
/// Σ factor · variable.
template <class Ring>
using RingSum = std::vector<RingTerm<Ring>>;

/// The order of the rotations of a ring that is used for Z_q, a multiple of q.
template <class Ring>
constexpr int ringOrder(int q) {
  if constexpr (Ring::kIsEuclidean)
    return Ring::kOrder;
  else
    return q;
}

/// z = e^{i2π turn/order} z_first + Σ factor · t_chain; the factors are units or sums of two units.
template <class Ring>
struct CopyPlace {
  int turn = 0;
  RingSum<Ring> shift;
};

/// Going once counterclockwise around an interior node: z = e^{i2π turn/order} z + Σ factor · t must hold again.
template <class Ring>
struct NodeClosure {
  VertexId vertex;
  CopyPlace<Ring> place;
};

/// Chains with their rotations: across chain c, z_right = e^{i2π turn[c]/order} z_left + t_c.
struct TurnedChains {
  const TriMesh& mesh;
  const PerEdge<char>& isSeam;
  const SeamChains& chains;
  const std::vector<int>& turn;
  int order = 4;
};

/// The place after crossing the seam edge `out`, which leaves a vertex, from its right to its left.
template <class Ring>
CopyPlace<Ring> crossSeam(const TurnedChains& seams, const CopyPlace<Ring>& from, HalfedgeId out) {
  const int c = seams.chains.chain[out];
  const bool isLeft = seams.chains.isLeft[out] != 0;
  const int turn = isLeft ? -seams.turn[at(c)] : seams.turn[at(c)];
  const Ring unit = Ring::turned(turn, seams.order);
  CopyPlace<Ring> to{reduceTurn(from.turn + turn, seams.order), {}};
  const Ring own = isLeft ? -unit : Ring::turned(0, seams.order);
  bool isAdded = false;
  for (const RingTerm<Ring>& t : from.shift) {
    Ring factor = unit * t.factor;
    if (t.variable == c) {
      factor = factor + own;
      isAdded = true;
    }
    if (!isZero(factor)) to.shift.push_back({t.variable, factor});
  }
  if (!isAdded) to.shift.push_back({c, own});
  return to;
}

/// Visits the halfedges that leave v counterclockwise, sector after sector, from firstOfSectors on.
/// @param visit  called with (halfedge, whether a sector starts at it, the place of that sector's copy)
/// @return the closure of an interior vertex on a seam
template <class Ring, class Visit>
std::optional<CopyPlace<Ring>> walkSectors(const TurnedChains& seams, VertexId v, Visit visit) {
  const TriMesh& mesh = seams.mesh;
  const HalfedgeId start = firstOfSectors(mesh, seams.isSeam, v);
  CopyPlace<Ring> now;
  visit(start, true, now);
  HalfedgeId h = mesh.nextOutgoing(start);
  for (; h.isValid() && h != start; h = mesh.nextOutgoing(h)) {
    const bool isFirst = seams.isSeam[mesh.edge(h)] != 0;
    if (isFirst) now = crossSeam(seams, now, h);
    visit(h, isFirst, now);
  }
  if (!h.isValid() || !seams.isSeam[mesh.edge(start)]) return {};
  return crossSeam(seams, now, start);
}

}  // namespace hgp
