#include "hgp/optimize/feature_lengths.h"

#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/stable_order.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/real_row.h"

namespace hgp {
namespace {

constexpr int kMaxNewtonSteps = 60;
/// Weight of |x|², relative to the matrix: what no edge determines stays 0.
constexpr double kHold = 1e-9;
/// Shares of the largest shortfall and of 1: shorter edges are listed, and none is beyond doubt positive.
constexpr double kShortShare = 0.1, kDoubt = 0.5;

using Sparse = Eigen::SparseMatrix<double>;

/// The signed length of each feature edge over its length, as a row over the unknowns that occur.
struct LengthRows {
  struct Entry {
    int unknown;
    double value;
  };
  std::vector<std::vector<Entry>> rows;
  int unknowns = 0;

  /// G x
  Eigen::VectorXd times(const Eigen::VectorXd& x) const {
    Eigen::VectorXd lengths = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t e = 0; e < rows.size(); ++e)
      for (const Entry& a : rows[e])
        lengths[static_cast<Eigen::Index>(e)] += a.value * x[a.unknown];
    return lengths;
  }
  /// Gᵀ r
  Eigen::VectorXd transposedTimes(const Eigen::VectorXd& r) const {
    Eigen::VectorXd x = Eigen::VectorXd::Zero(unknowns);
    for (std::size_t e = 0; e < rows.size(); ++e)
      for (const Entry& a : rows[e]) x[a.unknown] += a.value * r[static_cast<Eigen::Index>(e)];
    return x;
  }
  /// Gᵀ D G + hold, D with 1 at the rows with r > 0 and 0 elsewhere; all of them have the same pattern.
  Sparse normal(const Eigen::VectorXd& r, double hold) const {
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t e = 0; e < rows.size(); ++e) {
      const double weight = r[static_cast<Eigen::Index>(e)] > 0.0 ? 1.0 : 0.0;
      for (const Entry& a : rows[e])
        for (const Entry& b : rows[e])
          entries.emplace_back(a.unknown, b.unknown, weight * a.value * b.value);
    }
    for (int i = 0; i < unknowns; ++i) entries.emplace_back(i, i, hold);
    Sparse H(unknowns, unknowns);
    H.setFromTriplets(entries.begin(), entries.end());
    return H;
  }
  double squaredNorm() const {
    double sum = 0.0;
    for (const std::vector<Entry>& row : rows)
      for (const Entry& a : row) sum += a.value * a.value;
    return sum;
  }
};

LengthRows lengthRows(const StraightSystem& straight) {
  const SeamlessSystem& s = straight.system;
  std::vector<int> index(at(straight.unknowns.count));
  std::iota(index.begin(), index.end(), 0);
  RealRow row(straight.unknowns, index, std::vector<double>(index.size(), 0.0));
  std::vector<int> column(index.size(), -1);
  LengthRows G;
  const auto take = [&] {
    std::vector<LengthRows::Entry>& entries = G.rows.emplace_back();
    row.take([&](int unknown, double value) {
      if (column[at(unknown)] < 0) column[at(unknown)] = G.unknowns++;
      entries.push_back({column[at(unknown)], value});
    });
  };
  for (const StraightEdge& edge : straight.edges) {
    const double scale = (edge.heading < 2 ? 1.0 : -1.0) / s.geometry.length[edge.h];
    row.add(s.cut.copy[TriMesh::next(edge.h)].i, edge.heading % 2, scale);
    row.add(s.cut.copy[edge.h].i, edge.heading % 2, -scale);
    take();
  }
  for (const SideDistance& d : straight.distances) {
    row.add(d.sum, 1.0 / d.length);
    take();
  }
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
  const LengthRows G = lengthRows(straight);
  LengthFit out;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(G.unknowns);
  const double hold = kHold * (1.0 + G.squaredNorm() / std::max(1, G.unknowns));
  const auto shortfall = [&](const Eigen::VectorXd& at) {
    Eigen::VectorXd r = G.times(at);
    for (double& length : r) length = std::max(1.0 - length, 0.0);
    return r;
  };
  const auto value = [&](const Eigen::VectorXd& at) {
    return shortfall(at).squaredNorm() + hold * at.squaredNorm();
  };
  Eigen::VectorXd r = shortfall(x);
  linalg::MultifrontalCholesky<double> factor;
  const linalg::Graph graph = linalg::graphOf(G.normal(r, hold));
  factor.analyze(graph, linalg::nestedDissection(graph));
  for (int step = 0; step < kMaxNewtonSteps; ++step) {
    if (!factor.factor(G.normal(r, hold))) break;
    const Eigen::VectorXd down = G.transposedTimes(r) - hold * x;
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
  const auto shortOf = [&](std::size_t e) { return r[static_cast<Eigen::Index>(e)]; };
  const std::size_t edges = straight.edges.size();
  for (const std::size_t e : stableOrder(
           G.rows.size(), [&](std::size_t a, std::size_t b) { return shortOf(a) > shortOf(b); }))
    if (shortOf(e) > kShortShare * largest)
      out.edges.push_back(e < edges ? straight.edges[e].h : straight.distances[e - edges].side);
  return out;
}

}  // namespace hgp
