#include "hgp/grid/straight_places.h"

#include <cmath>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

using ComplexRows = Eigen::SparseMatrix<Complex, Eigen::RowMajor>;

/// Every copy as a sum over the free vertices, then the coordinates of the basis.
class CopyRows {
 public:
  CopyRows(const SeamStructure& seams, const IntegerBasis& basis, const PerVertex<int>& closureOf)
      : seams_(seams), basis_(basis), closureOf_(closureOf), unknownOf_(at(closureOf.size()), -1) {
    for (int v = 0; v < closureOf.size(); ++v)
      if (closureOf[VertexId(v)] < 0 && seams.firstCopy[VertexId(v)] >= 0) {
        unknownOf_[VertexId(v)] = static_cast<int>(vertexOf_.size());
        vertexOf_.push_back(v);
      }
  }

  std::vector<int> vertexOf() const { return vertexOf_; }

  ComplexRows make() const {
    const int vertices = static_cast<int>(vertexOf_.size());
    std::vector<Eigen::Triplet<Complex>> entries;
    for (int c = 0; c < static_cast<int>(seams_.vertexOf.size()); ++c) {
      const VertexId v = seams_.vertexOf[at(c)];
      if (!v.isValid()) continue;
      const CopyPlace<Gaussian>& place = seams_.place(c);
      const Complex unit = toComplex(quarterTurn(place.turn));
      const auto addSum = [&](const GaussianSum& sum, const Complex& factor) {
        for (const GaussianTerm& t : sum)
          for (const GaussianTerm& y : basis_.value[at(t.variable)])
            entries.emplace_back(c, vertices + y.variable, factor * toComplex(t.factor * y.factor));
      };
      if (closureOf_[v] < 0) {
        entries.emplace_back(c, unknownOf_[v], unit);
      } else {
        const CopyPlace<Gaussian>& closure = seams_.closures[at(closureOf_[v])].place;
        addSum(closure.shift,
               unit * portable::divide(1.0, 1.0 - toComplex(quarterTurn(closure.turn))));
      }
      addSum(place.shift, 1.0);
    }
    ComplexRows rows(static_cast<Eigen::Index>(seams_.vertexOf.size()), vertices + basis_.size());
    rows.setFromTriplets(entries.begin(), entries.end());
    return rows;
  }

 private:
  const SeamStructure& seams_;
  const IntegerBasis& basis_;
  const PerVertex<int>& closureOf_;
  PerVertex<int> unknownOf_;
  std::vector<int> vertexOf_;
};

/// 2x as an integer. The product with a place may exceed 64 bits on the way; sums of such products are correct if their
/// result is in range, because unsigned numbers wrap around.
std::uint64_t twice(double x) { return static_cast<std::uint64_t>(std::llround(2.0 * x)); }

}  // namespace

std::optional<StraightPlaces> StraightPlaces::make(const TriMesh& mesh, const SeamStructure& seams,
                                                   const IntegerBasis& basis,
                                                   const PerVertex<int>& closureOf,
                                                   const UvMap& map,
                                                   const std::vector<EdgeId>& features) {
  std::vector<EqualCoordinate> equations;
  PerVertex<char> isTied(at(mesh.vertexCount()), 0);
  for (EdgeId e : features) {
    const HalfedgeId h = mesh.halfedge(e);
    const int a = seams.copy[h], b = seams.copy[TriMesh::next(h)];
    const Vec2 &p = map.uv[at(a)], &q = map.uv[at(b)];
    equations.push_back({a, b, std::fabs(q[1] - p[1]) < std::fabs(q[0] - p[0])});
    isTied[mesh.tail(h)] = isTied[mesh.head(h)] = 1;
  }
  const CopyRows copies(seams, basis, closureOf);
  std::vector<int> vertexOf = copies.vertexOf();
  std::vector<char> isShared(vertexOf.size() + at(basis.size()), 1);
  std::fill(isShared.begin(), isShared.begin() + static_cast<std::ptrdiff_t>(vertexOf.size()), 0);
  std::optional<RealUnknowns> unknowns = equateCoordinates(copies.make(), isShared, equations);
  if (!unknowns) return {};
  const double* factors = unknowns->rows.valuePtr();
  for (Eigen::Index i = 0; i < unknowns->rows.nonZeros(); ++i)
    if (2.0 * factors[i] != std::nearbyint(2.0 * factors[i])) return {};
  return StraightPlaces(std::move(*unknowns), std::move(vertexOf), std::move(isTied));
}

std::optional<std::vector<Gaussian>> StraightPlaces::round(
    const std::vector<Complex>& firstUv, const std::vector<Complex>& translation) const {
  std::vector<std::uint64_t> x;
  for (const int variable : unknowns_.variable) {
    const std::size_t unknown = at(variable / 2);
    const bool isVertex = unknown < vertexOf_.size();
    const Complex value =
        isVertex ? firstUv[at(vertexOf_[unknown])] : translation[unknown - vertexOf_.size()];
    const double part = variable % 2 == 0 ? value.real() : value.imag();
    x.push_back(
        static_cast<std::uint64_t>(isVertex ? std::llround(part) : 2 * std::llround(part / 2.0)));
  }
  std::vector<Gaussian> places(at(unknowns_.rows.rows() / 2));
  for (std::size_t c = 0; c < places.size(); ++c) {
    std::int64_t parts[2];
    for (const std::size_t part : {0, 1}) {
      std::uint64_t sum = 0;
      for (RealUnknowns::Rows::InnerIterator it(unknowns_.rows,
                                                static_cast<Eigen::Index>(2 * c + part));
           it; ++it)
        sum += twice(it.value()) * x[at(it.col())];
      parts[part] = static_cast<std::int64_t>(sum);
      if (parts[part] % 2 != 0) return {};
    }
    places[c] = {parts[0] / 2, parts[1] / 2};
  }
  return places;
}

}  // namespace hgp
