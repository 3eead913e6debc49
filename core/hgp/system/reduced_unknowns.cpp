#include "hgp/system/reduced_unknowns.h"

#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/seams/relations.h"
#include "hgp/system/row_builder.h"

namespace hgp {
namespace {

/// numerator / denominator, exactly; no denominator: 1.
template <class Ring>
struct RingFraction {
  Ring numerator;
  std::optional<Ring> denominator;

  RingFraction times(const Ring& factor) const { return {numerator * factor, denominator}; }
  RingFraction over(const Ring& divisor) const {
    return {numerator, denominator ? *denominator * divisor : divisor};
  }
  RingFraction plus(const RingFraction& other) const {
    if (!denominator && !other.denominator) return {numerator + other.numerator, {}};
    if (!denominator) return {numerator * *other.denominator + other.numerator, other.denominator};
    if (!other.denominator) return other.plus(*this);
    if (*denominator == *other.denominator) return {numerator + other.numerator, denominator};
    return {numerator * *other.denominator + other.numerator * *denominator,
            *denominator * *other.denominator};
  }
  Complex value() const {
    const Complex top = toComplex(numerator);
    return denominator ? portable::divide(top, toComplex(*denominator)) : top;
  }
};

/// Reduces the unknowns over a ring that contains the rotations.
template <class Ring>
class Reducer {
 public:
  Reducer(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams)
      : mesh_(mesh), cut_(cut), order_(ringOrder<Ring>(seams.q)), step_(order_ / seams.q) {
    for (const SeamChain& chain : cut.chains)
      turn_.push_back(seams.rotation[chain.left.front()] * step_);
  }

  ReducedUnknowns run() {
    places_.resize(at(cut_.vertexCount()));
    closure_.resize(at(mesh_.vertexCount()));
    std::vector<RingSum<Ring>> relations;
    for (VertexId v : mesh_.vertices()) {
      if (mesh_.isIsolated(v)) continue;
      walk(v);
      if (cut_.isSeamNode[v] && !mesh_.isBoundary(v) && closure(v).turn == 0)
        relations.push_back(closure(v).shift);
    }
    translations_ = eliminateRelations(cut_.chainCount(), relations);
    return collect();
  }

 private:
  CopyPlace<Ring>& closure(VertexId v) { return closure_[at(v.i)]; }

  void walk(VertexId v) {
    const TurnedChains seams{mesh_, cut_.isSeam, cut_, turn_, order_};
    auto closed =
        walkSectors<Ring>(seams, v, [&](HalfedgeId h, bool isFirst, const CopyPlace<Ring>& place) {
          if (isFirst && (place.turn != 0 || !place.shift.empty()))
            places_[at(cut_.copy[h].i)] = place;
        });
    if (closed) closure(v) = std::move(*closed);
  }

  void nameUnknowns(ReducedUnknowns& unknowns) {
    unknowns.vertexUnknown = PerVertex<int>(at(mesh_.vertexCount()), -1);
    for (VertexId v : mesh_.vertices())
      if (!mesh_.isIsolated(v) && closure(v).turn == 0)
        unknowns.vertexUnknown[v] = unknowns.count++;
    unknowns.chainUnknown.assign(cut_.chains.size(), -1);
    for (int c = 0; c < cut_.chainCount(); ++c)
      if (translations_.isFree[at(c)]) unknowns.chainUnknown[at(c)] = unknowns.count++;
  }

  /// Adds Σ factor · t / divisor to the row's translations, in terms of the free ones.
  void addShift(const RingSum<Ring>& sum, const Ring& factor, const std::optional<Ring>& divisor) {
    const auto addOne = [&](int c, RingFraction<Ring> fraction) {
      if (divisor) fraction = fraction.over(*divisor);
      for (auto& [chain, value] : shift_)
        if (chain == c) {
          value = value.plus(fraction);
          return;
        }
      shift_.emplace_back(c, std::move(fraction));
    };
    for (const RingTerm<Ring>& t : sum) {
      const Ring own = factor * t.factor;
      if (translations_.isFree[at(t.variable)]) {
        addOne(t.variable, {own, {}});
        continue;
      }
      const auto& solved = translations_.value[at(t.variable)];
      for (const RingTerm<Ring>& f : solved.sum)
        addOne(f.variable, {own * f.factor, solved.denominator});
    }
  }

  ReducedUnknowns collect() {
    ReducedUnknowns unknowns;
    nameUnknowns(unknowns);
    unknowns.turn = PerCutVertex<int>(at(cut_.vertexCount()), 0);
    RowBuilder builder(unknowns.count, cut_.vertexCount(), at(cut_.vertexCount()));
    const Ring one = Ring::turned(0, order_);
    for (int c = 0; c < cut_.vertexCount(); ++c) {
      const VertexId v = cut_.parent[CutVertexId(c)];
      const CopyPlace<Ring>& place = places_[at(c)];
      unknowns.turn[CutVertexId(c)] = place.turn / step_;
      const Ring R = Ring::turned(place.turn, order_);
      shift_.clear();
      if (unknowns.vertexUnknown[v] >= 0)
        builder.add(unknowns.vertexUnknown[v], toComplex(R));
      else
        addShift(closure(v).shift, R, one - Ring::turned(closure(v).turn, order_));
      addShift(place.shift, one, {});
      for (const auto& [chain, value] : shift_)
        if (!isZero(value.numerator)) builder.add(unknowns.chainUnknown[at(chain)], value.value());
      builder.endRow(0.0);
    }
    unknowns.copies = builder.take();
    return unknowns;
  }

  const TriMesh& mesh_;
  const CutMesh& cut_;
  const int order_;
  const int step_;         // turns of the ring per turn of Z_q
  std::vector<int> turn_;  // by chain
  std::vector<CopyPlace<Ring>> places_;
  std::vector<CopyPlace<Ring>> closure_;
  FreeVariables<Ring> translations_;
  std::vector<std::pair<int, RingFraction<Ring>>> shift_;  // of the row that is being made
};

}  // namespace

ReducedUnknowns reduceUnknowns(const TriMesh& mesh, const CutMesh& cut,
                               const SeamRotations& seams) {
  if (Gaussian::kOrder % seams.q == 0) return Reducer<Gaussian>(mesh, cut, seams).run();
  if (Eisenstein::kOrder % seams.q == 0) return Reducer<Eisenstein>(mesh, cut, seams).run();
  return Reducer<Cyclotomic>(mesh, cut, seams).run();
}

Eigen::VectorXcd readUnknowns(const TriMesh& mesh, const CutMesh& cut, const SeamRotations& seams,
                              const ReducedUnknowns& unknowns, const std::vector<Complex>& z) {
  const auto value = [&](CutVertexId c) { return z[at(c.i)]; };
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
