#include "hgp/grid/seam_structure.h"

#include <algorithm>
#include <array>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

Complex valueOf(const std::vector<Vec2>& uv, int copy) {
  return {uv[at(copy)][0], uv[at(copy)][1]};
}

class SeamReader {
 public:
  SeamReader(const TriMesh& mesh, const UvMap& map, int q, const std::vector<VertexId>& cones)
      : mesh_(mesh), map_(map), q_(q), isNode_(at(mesh.vertexCount()), 0) {
    for (VertexId v : cones) isNode_[v] = 1;
  }

  bool run() {
    if (!gatherCopies()) return false;
    findSeams();
    for (VertexId v : mesh_.vertices())
      if (isNode_[v]) traceFrom(v);
    for (EdgeId e : mesh_.edges())  // closed chains without a node
      if (isSeam_[e] && chain_[mesh_.halfedge(e)] < 0) {
        isNode_[mesh_.tail(mesh_.halfedge(e))] = 1;
        traceFrom(mesh_.tail(mesh_.halfedge(e)));
      }
    for (TurnedChain& chain : out_.chains) chain.turn = measuredTurn(chain);
    out_.firstCopy = PerVertex<int>(at(mesh_.vertexCount()), -1);
    out_.placeOf.assign(map_.uv.size(), -1);
    for (VertexId v : mesh_.vertices())
      if (!mesh_.isIsolated(v) && !walk(v)) return false;
    return true;
  }

  SeamStructure take() { return std::move(out_); }

 private:
  bool gatherCopies() {
    if (map_.cornerUv.size() != at(mesh_.faceCount())) return false;
    out_.copy = PerHalfedge<int>(at(mesh_.halfedgeCount()), -1);
    out_.vertexOf.assign(map_.uv.size(), VertexId());
    for (HalfedgeId h : mesh_.halfedges()) {
      const int c = map_.cornerUv[at(h.i / 3)][at(h.i % 3)];
      if (c < 0 || at(c) >= map_.uv.size()) return false;
      VertexId& owner = out_.vertexOf[at(c)];
      if (owner.isValid() && owner != mesh_.tail(h)) return false;
      owner = mesh_.tail(h);
      out_.copy[h] = c;
    }
    return true;
  }

  void findSeams() {
    isSeam_ = PerEdge<char>(at(mesh_.edgeCount()), 0);
    chain_ = PerHalfedge<int>(at(mesh_.halfedgeCount()), -1);
    isLeft_ = PerHalfedge<char>(at(mesh_.halfedgeCount()), 0);
    PerVertex<int> degree(at(mesh_.vertexCount()), 0);
    for (EdgeId e : mesh_.edges()) {
      const HalfedgeId h = mesh_.halfedge(e);
      if (mesh_.isBoundary(h)) continue;
      const HalfedgeId twin = mesh_.twin(h);
      isSeam_[e] = out_.copy[h] != out_.copy[TriMesh::next(twin)] ||
                   out_.copy[TriMesh::next(h)] != out_.copy[twin];
      if (!isSeam_[e]) continue;
      ++degree[mesh_.tail(h)];
      ++degree[mesh_.head(h)];
    }
    for (VertexId v : mesh_.vertices())
      isNode_[v] = degree[v] > 0 && (isNode_[v] || degree[v] != 2 || mesh_.isBoundary(v));
  }

  void traceFrom(VertexId node) {
    for (HalfedgeId out : outgoingHalfedges(mesh_, node)) {
      if (!isSeam_[mesh_.edge(out)] || chain_[out] >= 0) continue;
      TurnedChain chain;
      for (HalfedgeId h = out;;) {
        chain.left.push_back(h);
        chain_[h] = chain_[mesh_.twin(h)] = out_.chainCount();
        isLeft_[h] = 1;
        if (isNode_[mesh_.head(h)]) break;
        h = continued(h);
      }
      out_.chains.push_back(std::move(chain));
    }
  }

  /// The other seam edge at the head of h, which is not a node.
  HalfedgeId continued(HalfedgeId h) const {
    for (HalfedgeId out : outgoingHalfedges(mesh_, mesh_.head(h)))
      if (isSeam_[mesh_.edge(out)] && mesh_.edge(out) != mesh_.edge(h)) return out;
    return h;
  }

  int measuredTurn(const TurnedChain& chain) const {
    double best = -1.0;
    int turn = 0;
    for (HalfedgeId h : chain.left) {
      const HalfedgeId twin = mesh_.twin(h);
      const Complex left =
          valueOf(map_.uv, out_.copy[TriMesh::next(h)]) - valueOf(map_.uv, out_.copy[h]);
      const Complex right =
          valueOf(map_.uv, out_.copy[twin]) - valueOf(map_.uv, out_.copy[TriMesh::next(twin)]);
      const Complex ratio = right * std::conj(left);
      const std::array<double, 4> fit{ratio.real(), ratio.imag(), -ratio.real(), -ratio.imag()};
      if (portable::abs(ratio) <= best) continue;
      best = portable::abs(ratio);
      turn = 0;
      for (int r = 0; r < 4; r += 4 / q_)
        if (fit[at(r)] > fit[at(turn)]) turn = r;
    }
    return turn;
  }

  /// Crosses the seam edge `out`, which leaves a vertex, from its right to its left.
  CopyPlace cross(const CopyPlace& from, HalfedgeId out) const {
    const int c = chain_[out];
    const bool isLeft = isLeft_[out] != 0;
    const int turn = isLeft ? -out_.chains[at(c)].turn : out_.chains[at(c)].turn;
    const Gaussian unit = quarterTurn(turn);
    CopyPlace to{reduceTurn(from.turn + turn, 4), {}};
    const Gaussian own = isLeft ? -unit : Gaussian{1, 0};
    bool isAdded = false;
    for (const GaussianTerm& t : from.shift) {
      Gaussian factor = unit * t.factor;
      if (t.variable == c) {
        factor = factor + own;
        isAdded = true;
      }
      if (!isZero(factor)) to.shift.push_back({t.variable, factor});
    }
    if (!isAdded) to.shift.push_back({c, own});
    return to;
  }

  bool walk(VertexId v) {
    HalfedgeId start = mesh_.outgoing(v);
    bool isOnSeam = false;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      if (!isSeam_[mesh_.edge(h)]) continue;
      if (!isOnSeam && !mesh_.isBoundary(v)) start = h;
      isOnSeam = true;
    }
    out_.firstCopy[v] = out_.copy[start];
    CopyPlace now;
    int copy = out_.copy[start];
    if (isOnSeam && !setPlace(copy, now)) return false;
    HalfedgeId h = mesh_.nextOutgoing(start);
    for (; h.isValid() && h != start; h = mesh_.nextOutgoing(h)) {
      if (isSeam_[mesh_.edge(h)]) {
        now = cross(now, h);
        copy = out_.copy[h];
        if (!setPlace(copy, now)) return false;
      } else if (out_.copy[h] != copy) {
        return false;
      }
    }
    if (h.isValid() && isSeam_[mesh_.edge(start)] && isNode_[v])
      out_.closures.push_back({v, cross(now, start)});
    return true;
  }

  /// A copy that two sectors share (a cone at the end of a seam) keeps its first place.
  bool setPlace(int copy, const CopyPlace& place) {
    int& slot = out_.placeOf[at(copy)];
    if (slot >= 0) return false;
    slot = static_cast<int>(out_.places.size());
    out_.places.push_back(place);
    return true;
  }

  const TriMesh& mesh_;
  SeamStructure out_;
  const UvMap& map_;
  const int q_;
  PerVertex<char> isNode_;
  PerEdge<char> isSeam_;
  PerHalfedge<int> chain_;
  PerHalfedge<char> isLeft_;
};

}  // namespace

std::optional<SeamStructure> readSeams(const TriMesh& mesh, const UvMap& map, int q,
                                       const std::vector<VertexId>& cones) {
  if (q != 1 && q != 2 && q != 4) return {};
  SeamReader reader(mesh, map, q, cones);
  if (!reader.run()) return {};
  return reader.take();
}

std::vector<Complex> chainTranslations(const SeamStructure& seams, const TriMesh& mesh,
                                       const std::vector<Vec2>& uv) {
  std::vector<Complex> translation;
  for (const TurnedChain& chain : seams.chains) {
    const HalfedgeId h = chain.left[chain.left.size() / 2];
    const Complex right = valueOf(uv, seams.copy[TriMesh::next(mesh.twin(h))]);
    translation.push_back(right - toComplex(quarterTurn(chain.turn)) * valueOf(uv, seams.copy[h]));
  }
  return translation;
}

std::vector<GaussianSum> closureRelations(const SeamStructure& seams) {
  std::vector<GaussianSum> relations;
  for (const NodeClosure& closure : seams.closures)
    if (closure.place.turn == 0) relations.push_back(closure.place.shift);
  return relations;
}

}  // namespace hgp
