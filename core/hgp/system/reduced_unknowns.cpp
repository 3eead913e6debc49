#include "hgp/system/reduced_unknowns.h"

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/system/row_builder.h"
#include "hgp/system/translations.h"

namespace hgp {
namespace {

/// A smaller sum of numbers of absolute value 1 is a rounding error of 0.
constexpr double kMinSum = 1e-13;

/// z = e^{i2π turn/q} z_v + Σ factor · t
struct CopyValue {
  int turn = 0;
  TranslationSum shift;
};

class Reducer {
 public:
  Reducer(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams)
      : mesh_(mesh),
        cut_(cut),
        seams_(seams),
        isLeft_(static_cast<std::size_t>(mesh.halfedgeCount()), 0) {
    for (const SeamChain& chain : cut.chains)
      for (HalfedgeId h : chain.left) isLeft_[h] = 1;
  }

  ReducedUnknowns run() {
    values_.resize(static_cast<std::size_t>(cut_.vertexCount()));
    closure_.resize(static_cast<std::size_t>(mesh_.vertexCount()));
    std::vector<TranslationSum> relations;
    for (VertexId v : mesh_.vertices()) {
      if (mesh_.isIsolated(v)) continue;
      walk(v);
      const CopyValue& closed = closure(v);
      if (cut_.isSeamNode[v] && !mesh_.isBoundary(v) && closed.turn == 0)
        relations.push_back(closed.shift);
    }
    translations_ = solveTranslations(static_cast<int>(cut_.chains.size()), std::move(relations));
    return collect();
  }

 private:
  CopyValue& closure(VertexId v) { return closure_[static_cast<std::size_t>(v.i)]; }

  /// Crosses the seam edge `out`, which leaves a vertex, from its right to its left.
  CopyValue cross(const CopyValue& from, HalfedgeId out) const {
    const int chain = cut_.chain[out];
    const int r = seams_.rotation[mesh_.twin(out)];  // right → left
    const Complex R = rotation(r, seams_.q);
    CopyValue to{reduceTurn(from.turn + r, seams_.q), from.shift};
    for (TranslationTerm& t : to.shift) t.factor *= R;
    // The relation of a chain is z_right = R_c z_left + t_c.
    to.shift.push_back({chain, isLeft_[out] ? -R : Complex(1.0)});
    return to;
  }

  /// Values of all copies of v against its first one; `closure` is the first copy met again.
  void walk(VertexId v) {
    const CutVertexId first = cut_.firstCopy[v];
    HalfedgeId start = mesh_.outgoing(v);
    if (!mesh_.isBoundary(v))
      for (HalfedgeId h : outgoingHalfedges(mesh_, v))
        if (cut_.isSeam[mesh_.edge(h)]) {
          start = h;
          break;
        }
    CopyValue now;
    values_[static_cast<std::size_t>(first.i)] = now;
    HalfedgeId h = mesh_.nextOutgoing(start);
    for (; h.isValid() && h != start; h = mesh_.nextOutgoing(h)) {
      if (!cut_.isSeam[mesh_.edge(h)]) continue;
      now = cross(now, h);
      values_[static_cast<std::size_t>(cut_.copy[h].i)] = now;
    }
    if (h.isValid() && cut_.isSeam[mesh_.edge(start)]) closure(v) = cross(now, start);
  }

  TranslationSum free(const TranslationSum& sum) const {
    TranslationSum result;
    for (const TranslationTerm& t : sum)
      for (const TranslationTerm& f : translations_[static_cast<std::size_t>(t.chain)])
        result.push_back({f.chain, t.factor * f.factor});
    return result;
  }

  ReducedUnknowns collect() {
    ReducedUnknowns unknowns;
    unknowns.vertexUnknown = PerVertex<int>(static_cast<std::size_t>(mesh_.vertexCount()), -1);
    for (VertexId v : mesh_.vertices())
      if (!mesh_.isIsolated(v) && closure(v).turn == 0)
        unknowns.vertexUnknown[v] = unknowns.count++;
    unknowns.chainUnknown.assign(cut_.chains.size(), -1);
    for (std::size_t c = 0; c < translations_.size(); ++c)
      if (translations_[c].size() == 1 && translations_[c][0].chain == static_cast<int>(c))
        unknowns.chainUnknown[c] = unknowns.count++;

    unknowns.turn = PerCutVertex<int>(static_cast<std::size_t>(cut_.vertexCount()), 0);
    RowBuilder builder(unknowns.count, cut_.vertexCount(),
                       static_cast<std::size_t>(cut_.vertexCount()));
    for (int c = 0; c < cut_.vertexCount(); ++c) {
      const VertexId v = cut_.parent[CutVertexId(c)];
      const CopyValue& value = values_[static_cast<std::size_t>(c)];
      unknowns.turn[CutVertexId(c)] = value.turn;
      const Complex R = rotation(value.turn, seams_.q);
      if (unknowns.vertexUnknown[v] >= 0) {
        builder.add(unknowns.vertexUnknown[v], R);
      } else {
        const Complex scale = portable::divide(R, 1.0 - rotation(closure(v).turn, seams_.q));
        for (const TranslationTerm& t : free(closure(v).shift))
          builder.add(unknowns.chainUnknown[static_cast<std::size_t>(t.chain)], scale * t.factor);
      }
      for (const TranslationTerm& t : free(value.shift))
        builder.add(unknowns.chainUnknown[static_cast<std::size_t>(t.chain)], t.factor);
      builder.endRow(kMinSum);
    }
    unknowns.copies = builder.take();
    return unknowns;
  }

  const TriMesh& mesh_;
  const CutMesh& cut_;
  const SeamRotations& seams_;
  PerHalfedge<char> isLeft_;
  std::vector<CopyValue> values_;
  std::vector<CopyValue> closure_;
  std::vector<TranslationSum> translations_;
};

}  // namespace

ReducedUnknowns reduceUnknowns(const TriMesh& mesh, const CutMesh& cut,
                               const SeamRotations& seams) {
  return Reducer(mesh, cut, seams).run();
}

Eigen::VectorXcd readUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
                              const ReducedUnknowns& unknowns, const std::vector<Complex>& z) {
  const auto value = [&](CutVertexId c) { return z[static_cast<std::size_t>(c.i)]; };
  Eigen::VectorXcd x = Eigen::VectorXcd::Zero(unknowns.count);
  for (VertexId v : mesh.vertices())
    if (unknowns.vertexUnknown[v] >= 0) x[unknowns.vertexUnknown[v]] = value(cut.firstCopy[v]);
  for (std::size_t c = 0; c < cut.chains.size(); ++c) {
    if (unknowns.chainUnknown[c] < 0) continue;
    const HalfedgeId left = cut.chains[c].left.front();
    const Complex R = rotation(seams.rotation[left], seams.q);
    x[unknowns.chainUnknown[c]] =
        value(cut.copy[TriMesh::next(mesh.twin(left))]) - R * value(cut.copy[left]);
  }
  return x;
}

}  // namespace hgp
