#include "hgp/grid/lattice_snapper.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "hgp/grid/lattice.h"
#include "hgp/grid/positive_repair.h"

namespace hgp {
namespace {

template <class Ring>
Ring evaluate(const RingSum<Ring>& sum, const std::vector<Ring>& values) {
  Ring total;
  for (const RingTerm<Ring>& t : sum) total = total + t.factor * values[at(t.variable)];
  return total;
}

/// z = T/(1 − e^{i2π turn/o}); the step of the lattice divides T, and the denominator divides the step.
template <class Ring>
Ring fixedPoint(const CopyPlace<Ring>& closure, const std::vector<Ring>& chain) {
  return exactQuotient(evaluate(closure.shift, chain),
                       Ring::turned(0) - Ring::turned(closure.turn));
}

/// Translations of the chains, in coordinates of the basis; rounded where they are integers.
template <class Ring>
std::vector<Complex> coordinates(const SeamStructureOver<Ring>& seams,
                                 const LatticeBasis<Ring>& basis, const TriMesh& mesh,
                                 const std::vector<Vec2>& uv, bool isInteger) {
  const std::vector<Complex> t = chainTranslations(seams, mesh, uv);
  std::vector<Complex> values;
  for (const RingSum<Ring>& sum : basis.coordinate) {
    Complex value = 0.0;
    for (const RingTerm<Ring>& term : sum) value += toComplex(term.factor) * t[at(term.variable)];
    if (isInteger) value = {std::nearbyint(value.real()), std::nearbyint(value.imag())};
    values.push_back(value);
  }
  return values;
}

Complex scaled(const Complex& z, int exponent) {
  return {std::ldexp(z.real(), exponent), std::ldexp(z.imag(), exponent)};
}

}  // namespace

int gridExponent(const std::vector<Vec2>& uv, const StoredNumbers& numbers) {
  double bound = numbers.holdsFlipped ? 1.0 : 0.0;
  for (const Vec2& p : uv) {
    bound = std::max({bound, std::abs(p[0]), std::abs(p[1])});
    if (numbers.holdsFlipped) bound = std::max(bound, std::abs(1.0 - p[1]));
  }
  int exponent = 0;
  const double fraction = std::frexp(bound, &exponent);
  return exponent - numbers.digits - (fraction == 0.5 ? 1 : 0);
}

template <class Ring>
LatticeSnapper<Ring>::LatticeSnapper(const TriMesh& mesh, SeamStructureOver<Ring> seams,
                                     LatticeBasis<Ring> basis)
    : mesh_(&mesh),
      seams_(std::move(seams)),
      basis_(std::move(basis)),
      closureOf_(at(mesh.vertexCount()), -1) {
  for (std::size_t n = 0; n < seams_.closures.size(); ++n)
    if (seams_.closures[n].place.turn != 0)
      closureOf_[seams_.closures[n].vertex] = static_cast<int>(n);
}

template <class Ring>
std::optional<LatticeSnapper<Ring>> LatticeSnapper<Ring>::make(
    const TriMesh& mesh, const UvMap& map, int q, const std::vector<VertexId>& cones,
    const std::vector<EdgeId>& features) {
  std::optional<SeamStructureOver<Ring>> seams = readSeamsOver<Ring>(mesh, map, q, cones);
  if (!seams) return {};
  std::optional<LatticeBasis<Ring>> basis =
      solveRelations(seams->chainCount(), closureRelations(*seams));
  if (!basis) return {};
  LatticeSnapper snapper(mesh, std::move(*seams), std::move(*basis));
  if (features.empty()) return snapper;
  if constexpr (std::is_same_v<Ring, Gaussian>)
    snapper.straight_ = StraightPlaces::make(mesh, snapper.seams_, snapper.basis_,
                                             snapper.closureOf_, map, features);
  if (!snapper.straight_) return {};
  return snapper;
}

template <class Ring>
std::vector<Ring> LatticeSnapper<Ring>::round(const std::vector<Vec2>& uv, int exponent,
                                              bool isInteger) const {
  using L = Lattice<Ring>;
  const Complex perStep = std::conj(toComplex(L::kStep)) / static_cast<double>(norm(L::kStep));
  std::vector<Ring> y;
  for (const Complex& value : coordinates(seams_, basis_, *mesh_, uv, isInteger))
    y.push_back(L::kStep * L::nearest(scaled(value, -exponent) * perStep));
  std::vector<Ring> chain;
  for (const RingSum<Ring>& sum : basis_.value) chain.push_back(evaluate(sum, y));
  std::vector<Ring> points(uv.size());
  for (std::size_t c = 0; c < uv.size(); ++c) {
    const VertexId v = seams_.vertexOf[c];
    if (!v.isValid()) continue;
    const Vec2& first = uv[at(seams_.firstCopy[v])];
    const Ring z = closureOf_[v] >= 0 ? fixedPoint(seams_.closures[at(closureOf_[v])].place, chain)
                                      : L::nearest(scaled({first[0], first[1]}, -exponent));
    const CopyPlace<Ring>& place = seams_.place(static_cast<int>(c));
    points[c] = Ring::turned(place.turn) * z + evaluate(place.shift, chain);
  }
  return points;
}

template <class Ring>
std::optional<std::vector<Ring>> LatticeSnapper<Ring>::rounded(const std::vector<Vec2>& uv,
                                                               int exponent, bool isInteger) const {
  if constexpr (std::is_same_v<Ring, Gaussian>)
    if (straight_) {
      std::vector<Complex> first(at(mesh_->vertexCount()));
      for (VertexId v : mesh_->vertices()) {
        const int c = seams_.firstCopy[v];
        if (c >= 0) first[at(v.i)] = scaled({uv[at(c)][0], uv[at(c)][1]}, -exponent);
      }
      std::vector<Complex> translation = coordinates(seams_, basis_, *mesh_, uv, isInteger);
      for (Complex& t : translation) t = scaled(t, -exponent);
      return straight_->round(first, translation);
    }
  return round(uv, exponent, isInteger);
}

template <class Ring>
std::optional<SnappedMap> LatticeSnapper<Ring>::snap(const std::vector<Vec2>& uv, int exponent,
                                                     const StoredNumbers& numbers) const {
  std::optional<std::vector<Ring>> made = rounded(uv, exponent, numbers.hasIntegerTranslations);
  if (!made) return {};
  std::vector<Ring>& points = *made;
  const auto fits = [&] {
    return std::all_of(points.begin(), points.end(),
                       [&](Ring p) { return Lattice<Ring>::fits(p, exponent, numbers); });
  };
  if (!fits()) return {};
  SnappedMap out;
  PositiveRepair<Ring> repair(*mesh_, seams_, closureOf_, straight_ ? &*straight_ : nullptr,
                              points);
  for (FaceId f : mesh_->faces())
    if (!repair.isPositive(f)) out.notPositive.push_back(f);
  if (!out.notPositive.empty()) {
    out.moved = repair.run(out.notPositive);
    if (!fits()) return {};
  }
  out.uv = uv;
  for (std::size_t c = 0; c < points.size(); ++c)
    if (seams_.vertexOf[c].isValid()) out.uv[c] = Lattice<Ring>::stored(points[c], exponent);
  return out;
}

template class LatticeSnapper<Gaussian>;
template class LatticeSnapper<Eisenstein>;

}  // namespace hgp
