#include "hgp/grid/snap.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/wide_integer.h"

namespace hgp {
namespace {

constexpr int kPasses = 12;  ///< over the triangles that rounding flipped

/// Positions in steps, one Gaussian integer per copy.
using GridPoints = std::vector<Gaussian>;

WideInteger doubleArea(Gaussian a, Gaussian b, Gaussian c) {
  const Gaussian ab = b - a, ac = c - a;
  return WideInteger::product(ab.re, ac.im) - WideInteger::product(ab.im, ac.re);
}

/// Moves vertices of triangles that are not positive, all copies of a vertex together.
class PositiveRepair {
 public:
  /// @param straight  vertices on features stay; may be null
  PositiveRepair(const TriMesh& mesh, const SeamStructure& seams, const PerVertex<int>& closureOf,
                 const StraightPlaces* straight, GridPoints& points)
      : mesh_(mesh), seams_(seams), closureOf_(closureOf), straight_(straight), points_(points) {}

  bool isPositive(FaceId f) const { return area(f, VertexId(), {}).sign() > 0; }

  /// @return the number of vertices moved
  int run(std::vector<FaceId>& broken) {
    std::vector<char> isMoved(at(mesh_.vertexCount()), 0);
    for (int pass = 0; pass < kPasses && !broken.empty(); ++pass) {
      const std::int64_t reach = pass < kPasses / 2 ? 1 : 4;
      bool isAny = false;
      for (FaceId f : broken)
        for (VertexId v : mesh_.corners(f)) {
          if (closureOf_[v] >= 0 || (straight_ && straight_->isTied(v)) || !move(v, reach))
            continue;
          isMoved[at(v.i)] = 1;
          isAny = true;
        }
      std::erase_if(broken, [&](FaceId f) { return isPositive(f); });
      if (!isAny && reach > 1) break;
    }
    return static_cast<int>(std::count(isMoved.begin(), isMoved.end(), 1));
  }

 private:
  /// Twice the area of f in steps² with vertex v moved by d (as its first copy sees it).
  WideInteger area(FaceId f, VertexId v, Gaussian d) const {
    Gaussian p[3];
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const int c = seams_.copy[h];
      p[k] = points_[at(c)];
      if (mesh_.tail(h) == v) p[k] = p[k] + quarterTurn(seams_.place(c).turn) * d;
    }
    return doubleArea(p[0], p[1], p[2]);
  }
  WideInteger smallestArea(VertexId v, Gaussian d) const {
    WideInteger smallest;
    bool isFirst = true;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      const WideInteger a = area(TriMesh::face(h), v, d);
      if (isFirst || a < smallest) smallest = a;
      isFirst = false;
    }
    return smallest;
  }
  bool move(VertexId v, std::int64_t reach) {
    Gaussian best;
    WideInteger bestArea = smallestArea(v, best);
    for (std::int64_t du = -2; du <= 2; ++du)
      for (std::int64_t dv = -2; dv <= 2; ++dv) {
        const Gaussian d{du * reach, dv * reach};
        const WideInteger candidate = smallestArea(v, d);
        if (candidate <= bestArea) continue;
        bestArea = candidate;
        best = d;
      }
    if (isZero(best)) return false;
    std::vector<int> done;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) {
      const int c = seams_.copy[h];
      if (std::find(done.begin(), done.end(), c) != done.end()) continue;
      done.push_back(c);
      points_[at(c)] = points_[at(c)] + quarterTurn(seams_.place(c).turn) * best;
    }
    return true;
  }

  const TriMesh& mesh_;
  const SeamStructure& seams_;
  const PerVertex<int>& closureOf_;
  const StraightPlaces* straight_;
  GridPoints& points_;
};

Gaussian evaluate(const GaussianSum& sum, const std::vector<Gaussian>& values) {
  Gaussian total;
  for (const GaussianTerm& t : sum) total = total + t.factor * values[at(t.variable)];
  return total;
}

/// z = T/(1 − i^turn); T is even, and 1 − i^turn divides 2.
Gaussian fixedPoint(const CopyPlace<Gaussian>& closure, const std::vector<Gaussian>& chain) {
  return exactQuotient(evaluate(closure.shift, chain), Gaussian{1, 0} - quarterTurn(closure.turn));
}

bool fits(const GridPoints& points, int exponent, const StoredNumbers& numbers) {
  const std::int64_t limit = std::int64_t{1} << numbers.digits;
  if (numbers.holdsFlipped && (exponent > 0 || exponent < -62)) return false;
  const std::int64_t one = numbers.holdsFlipped ? std::int64_t{1} << -exponent : 0;
  return std::all_of(points.begin(), points.end(), [&](Gaussian p) {
    return std::abs(p.re) <= limit && std::abs(p.im) <= limit && std::abs(one - p.im) <= limit;
  });
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

SeamSnapper::SeamSnapper(const TriMesh& mesh, SeamStructure seams, IntegerBasis basis)
    : mesh_(&mesh),
      seams_(std::move(seams)),
      basis_(std::move(basis)),
      closureOf_(at(mesh.vertexCount()), -1) {
  for (std::size_t n = 0; n < seams_.closures.size(); ++n)
    if (seams_.closures[n].place.turn != 0)
      closureOf_[seams_.closures[n].vertex] = static_cast<int>(n);
}

std::optional<SeamSnapper> SeamSnapper::make(const TriMesh& mesh, const UvMap& map, int q,
                                             const std::vector<VertexId>& cones,
                                             const std::vector<EdgeId>& features) {
  std::optional<SeamStructure> seams = readSeams(mesh, map, q, cones);
  if (!seams) return {};
  std::optional<IntegerBasis> basis = solveRelations(seams->chainCount(), closureRelations(*seams));
  if (!basis) return {};
  SeamSnapper snapper(mesh, std::move(*seams), std::move(*basis));
  if (features.empty()) return snapper;
  snapper.straight_ =
      StraightPlaces::make(mesh, snapper.seams_, snapper.basis_, snapper.closureOf_, map, features);
  if (!snapper.straight_) return {};
  return snapper;
}

std::vector<Gaussian> SeamSnapper::round(const std::vector<Vec2>& uv, int exponent,
                                         bool isInteger) const {
  const auto steps = [&](double x) { return std::llround(std::ldexp(x, -exponent)); };
  const std::vector<Complex> t = chainTranslations(seams_, *mesh_, uv);
  std::vector<Gaussian> y;
  for (const GaussianSum& sum : basis_.coordinate) {
    Complex value = 0.0;
    for (const GaussianTerm& term : sum) value += toComplex(term.factor) * t[at(term.variable)];
    if (isInteger) value = {std::nearbyint(value.real()), std::nearbyint(value.imag())};
    y.push_back({2 * steps(value.real() / 2), 2 * steps(value.imag() / 2)});
  }
  std::vector<Gaussian> chain;
  for (const GaussianSum& sum : basis_.value) chain.push_back(evaluate(sum, y));
  GridPoints points(uv.size());
  for (std::size_t c = 0; c < uv.size(); ++c) {
    const VertexId v = seams_.vertexOf[c];
    if (!v.isValid()) continue;
    const Vec2& first = uv[at(seams_.firstCopy[v])];
    const Gaussian z = closureOf_[v] >= 0
                           ? fixedPoint(seams_.closures[at(closureOf_[v])].place, chain)
                           : Gaussian{steps(first[0]), steps(first[1])};
    const CopyPlace<Gaussian>& place = seams_.place(static_cast<int>(c));
    points[c] = quarterTurn(place.turn) * z + evaluate(place.shift, chain);
  }
  return points;
}

std::optional<GridPoints> SeamSnapper::roundStraight(const std::vector<Vec2>& uv, int exponent,
                                                     bool isInteger) const {
  const double steps = std::ldexp(1.0, -exponent);
  std::vector<Complex> first(at(mesh_->vertexCount()));
  for (VertexId v : mesh_->vertices()) {
    const int c = seams_.firstCopy[v];
    if (c >= 0) first[at(v.i)] = {uv[at(c)][0] * steps, uv[at(c)][1] * steps};
  }
  const std::vector<Complex> t = chainTranslations(seams_, *mesh_, uv);
  std::vector<Complex> translation;
  for (const GaussianSum& sum : basis_.coordinate) {
    Complex value = 0.0;
    for (const GaussianTerm& term : sum) value += toComplex(term.factor) * t[at(term.variable)];
    if (isInteger) value = {std::nearbyint(value.real()), std::nearbyint(value.imag())};
    translation.push_back(value * steps);
  }
  return straight_->round(first, translation);
}

std::optional<SnappedMap> SeamSnapper::snap(const std::vector<Vec2>& uv, int exponent,
                                            const StoredNumbers& numbers) const {
  std::optional<GridPoints> rounded =
      straight_ ? roundStraight(uv, exponent, numbers.hasIntegerTranslations)
                : round(uv, exponent, numbers.hasIntegerTranslations);
  if (!rounded || !fits(*rounded, exponent, numbers)) return {};
  GridPoints& points = *rounded;
  SnappedMap out;
  PositiveRepair repair(*mesh_, seams_, closureOf_, straight_ ? &*straight_ : nullptr, points);
  for (FaceId f : mesh_->faces())
    if (!repair.isPositive(f)) out.notPositive.push_back(f);
  if (!out.notPositive.empty()) {
    out.moved = repair.run(out.notPositive);
    if (!fits(points, exponent, numbers)) return {};
  }
  out.uv = uv;
  for (std::size_t c = 0; c < points.size(); ++c)
    if (seams_.vertexOf[c].isValid())
      out.uv[c] = {std::ldexp(static_cast<double>(points[c].re), exponent),
                   std::ldexp(static_cast<double>(points[c].im), exponent)};
  return out;
}

std::optional<UvMap> snapAligned(const TriMesh& mesh, UvMap map, int q,
                                 const std::vector<VertexId>& cones,
                                 const std::vector<EdgeId>& features) {
  const std::optional<SeamSnapper> snapper = SeamSnapper::make(mesh, map, q, cones, features);
  if (!snapper) return {};
  StoredNumbers numbers;
  numbers.hasIntegerTranslations = true;
  std::optional<SnappedMap> snapped =
      snapper->snap(map.uv, gridExponent(map.uv, numbers) + 1, numbers);
  if (!snapped || !snapped->notPositive.empty()) return {};
  map.uv = std::move(snapped->uv);
  return map;
}

}  // namespace hgp
