#include "hgp/verify/exact_seams.h"

#include <cmath>

#include "hgp/verify/lattice_points.h"

namespace hgp {
namespace {

/// a + b without rounding: `high` is the rounded sum, `low` its error. Two sums are equal as real
/// numbers if and only if both parts are equal, since `high` is a function of the real number.
struct Sum {
  double high, low;
};

Sum sumOf(double a, double b) {  // Knuth's two-sum
  const double high = a + b;
  const double fromB = high - a;
  return {high, (a - (high - fromB)) + (b - fromB)};
}

bool isEqual(const Sum& a, const Sum& b) { return a.high == b.high && a.low == b.low; }

bool isInteger(const Sum& s) { return std::rint(s.high) == s.high && std::rint(s.low) == s.low; }

/// i^turn p by swapping and negating.
Vec2 turned(int turn, const Vec2& p) {
  switch (turn) {
    case 0:
      return p;
    case 1:
      return {-p[1], p[0]};
    case 2:
      return {-p[0], -p[1]};
    default:
      return {p[1], -p[0]};
  }
}

/// t = z' − i^turn z, one sum per coordinate.
struct Translation {
  Sum u, v;
};

Translation translation(int turn, const Vec2& from, const Vec2& to) {
  const Vec2 p = turned(turn, from);
  return {sumOf(to[0], -p[0]), sumOf(to[1], -p[1])};
}

SeamPoint difference(const SeamPoint& p, const SeamPoint& q) { return {p.a - q.a, p.b - q.b}; }

/// n 2^exponent is an integer.
bool isWhole(std::int64_t n, int exponent) {
  const double value = std::ldexp(static_cast<double>(n), exponent);
  return value == std::rint(value);
}

ExactSeamFacts onTriangularLattice(const TriMesh& mesh, int q, const CornerUv& uv,
                                   const SeamFacts& seams) {
  ExactSeamFacts facts;
  facts.isApplicable = facts.isTriangular = true;
  const std::optional<LatticePoints> points = latticePoints(uv);
  for (const MeasuredSeam& seam : seams.seams) {
    const HalfedgeId h = mesh.halfedge(seam.edge), twin = mesh.twin(h);
    const auto translation = [&](HalfedgeId from, HalfedgeId to) {
      const auto& corner = points->corner;
      return difference(corner[at(to.i)], turnedBySixths(seam.r * (6 / q), corner[at(from.i)]));
    };
    if (!points || translation(h, TriMesh::next(twin)) != translation(TriMesh::next(h), twin)) {
      facts.inexact.push_back(seam.edge);
      continue;
    }
    ++facts.exact;
    const SeamPoint t = translation(h, TriMesh::next(twin));
    facts.integer += isWhole(t.a, points->exponent) && isWhole(t.b, points->exponent);
  }
  return facts;
}

}  // namespace

ExactSeamFacts measureExactSeams(const TriMesh& mesh, int q, const CornerUv& uv,
                                 const SeamFacts& seams) {
  if (q == 3 || q == 6) return onTriangularLattice(mesh, q, uv, seams);
  ExactSeamFacts facts;
  facts.isApplicable = q == 1 || q == 2 || q == 4;
  if (!facts.isApplicable) return facts;
  for (const MeasuredSeam& seam : seams.seams) {
    const int turn = seam.r * (4 / q);
    const HalfedgeId h = mesh.halfedge(seam.edge), twin = mesh.twin(h);
    const Translation tail = translation(turn, uv[h], uv[TriMesh::next(twin)]);
    const Translation head = translation(turn, uv[TriMesh::next(h)], uv[twin]);
    if (!isEqual(tail.u, head.u) || !isEqual(tail.v, head.v)) {
      facts.inexact.push_back(seam.edge);
      continue;
    }
    ++facts.exact;
    facts.integer += isInteger(tail.u) && isInteger(tail.v);
  }
  return facts;
}

}  // namespace hgp
