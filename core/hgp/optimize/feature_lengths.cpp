#include "hgp/optimize/feature_lengths.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/real_row.h"

namespace hgp {
namespace {

constexpr int kMostNewtonSteps = 60;
/// Weight of |x|², relative to the matrix: what no edge determines stays 0.
constexpr double kHold = 1e-9;
/// Shares of the largest shortfall and of 1: shorter edges are listed, and none is beyond doubt positive.
constexpr double kShortShare = 0.1, kDoubt = 0.5;

using Sparse = Eigen::SparseMatrix<double>;

/// |edges| × (unknowns that occur).
Sparse lengthRows(const StraightSystem& straight) {
  const SeamlessSystem& s = straight.system;
  std::vector<int> index(at(straight.unknowns.count));
  std::iota(index.begin(), index.end(), 0);
  RealRow row(straight.unknowns, index, std::vector<double>(index.size(), 0.0));
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<int> column(index.size(), -1);
  int columns = 0;
  for (std::size_t e = 0; e < straight.edges.size(); ++e) {
    const StraightEdge& edge = straight.edges[e];
    const double scale = (edge.heading < 2 ? 1.0 : -1.0) / s.geometry.length[edge.h];
    row.add(s.cut.copy[TriMesh::next(edge.h)].i, edge.heading % 2, scale);
    row.add(s.cut.copy[edge.h].i, edge.heading % 2, -scale);
    row.take([&](int unknown, double value) {
      if (column[at(unknown)] < 0) column[at(unknown)] = columns++;
      entries.emplace_back(static_cast<int>(e), column[at(unknown)], value);
    });
  }
  Sparse G(static_cast<Eigen::Index>(straight.edges.size()), columns);
  G.setFromTriplets(entries.begin(), entries.end());
  return G;
}

/// Whether two copies have the same real (part 0) or imaginary part for all values of the unknowns.
bool areEqual(const RealUnknowns& unknowns, int a, int b, int part) {
  RealUnknowns::Rows::InnerIterator p(unknowns.rows, 2 * a + part), q(unknowns.rows, 2 * b + part);
  for (; p && q; ++p, ++q)
    if (p.col() != q.col() || p.value() != q.value()) return false;
  return !p && !q;
}

std::vector<FaceId> flatFaces(const StraightSystem& straight) {
  std::vector<FaceId> flat;
  for (FaceId f : straight.system.mesh.faces()) {
    const auto copy = [&](int k) { return straight.system.cut.copy[TriMesh::halfedge(f, k)].i; };
    const auto isFlat = [&](int part) {
      return areEqual(straight.unknowns, copy(0), copy(1), part) &&
             areEqual(straight.unknowns, copy(0), copy(2), part);
    };
    const auto isPoint = [&](int j, int k) {
      return areEqual(straight.unknowns, copy(j), copy(k), 0) &&
             areEqual(straight.unknowns, copy(j), copy(k), 1);
    };
    if (isFlat(0) || isFlat(1) || isPoint(0, 1) || isPoint(1, 2) || isPoint(2, 0))
      flat.push_back(f);
  }
  return flat;
}

}  // namespace

LengthFit fitLengths(const StraightSystem& straight) {
  const Sparse G = lengthRows(straight), T = G.transpose();
  LengthFit out;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(G.cols());
  Sparse identity(G.cols(), G.cols());
  identity.setIdentity();
  const Sparse pattern = T * G + identity;
  const double hold = kHold * (1.0 + pattern.diagonal().sum() /
                                         std::max<double>(1.0, static_cast<double>(G.cols())));
  linalg::MultifrontalCholesky<double> factor;
  const linalg::Graph graph = linalg::graphOf(pattern);
  factor.analyze(graph, linalg::nestedDissection(graph));
  const auto shortfall = [&](const Eigen::VectorXd& at) {
    return Eigen::VectorXd((1.0 - (G * at).array()).max(0.0));
  };
  const auto value = [&](const Eigen::VectorXd& at) {
    return shortfall(at).squaredNorm() + hold * at.squaredNorm();
  };
  Eigen::VectorXd r = shortfall(x);
  for (int step = 0; step < kMostNewtonSteps; ++step) {
    const Eigen::VectorXd isShort = (r.array() > 0.0).cast<double>();
    // Every entry of the pattern stays, with numbers that may be 0.
    const Sparse H = 0.0 * pattern + Sparse(T * isShort.asDiagonal() * G) + hold * identity;
    if (!factor.factor(H)) break;
    const Eigen::VectorXd down = T * r - hold * x;
    const Eigen::VectorXd dx = factor.solve(Eigen::MatrixXd(down)).col(0);
    const double before = value(x), slope = down.dot(dx);
    double length = 1.0;
    while (length > 1e-6 && value(x + length * dx) > before - 0.1 * length * slope) length *= 0.5;
    x += length * dx;
    r = shortfall(x);
    if (slope <= 1e-12 * (1.0 + before)) break;
  }
  out.flat = flatFaces(straight);
  out.excess = r.squaredNorm() + static_cast<double>(out.flat.size());
  const double largest = r.size() > 0 ? r.maxCoeff() : 0.0;
  out.isPossible = largest < kDoubt && out.flat.empty();
  if (largest < kDoubt) return out;
  std::vector<std::size_t> order(straight.edges.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto shortOf = [&](std::size_t e) { return r[static_cast<Eigen::Index>(e)]; };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return shortOf(a) > shortOf(b); });
  for (const std::size_t e : order)
    if (shortOf(e) > kShortShare * largest) out.edges.push_back(straight.edges[e].h);
  return out;
}

}  // namespace hgp
