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

constexpr int kMaxIterations = 60;
/// Residuals and products t y of the interior point, relative to a shortfall of 1.
constexpr double kAccuracy = 1e-8;
/// Share of the step to the boundary.
constexpr double kStepToBoundary = 0.99;
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

/// Gᵀ W G + hold for one set of weights after another.
class Normal {
 public:
  Normal(const LengthRows& G, double hold) : G_(G), hold_(hold), matrix_(G.unknowns, G.unknowns) {
    std::vector<Eigen::Triplet<double>> pattern;
    pattern.reserve(at(G.unknowns));
    for (int i = 0; i < matrix_.rows(); ++i) pattern.emplace_back(i, i, 0.0);
    for (const auto& row : G.rows)
      for (const auto& a : row)
        for (const auto& b : row) pattern.emplace_back(a.unknown, b.unknown, 0.0);
    matrix_.setFromTriplets(pattern.begin(), pattern.end());
    for (int i = 0; i < matrix_.rows(); ++i) diagonal_.push_back(place(i, i));
    for (const auto& row : G.rows)
      for (const auto& a : row)
        for (const auto& b : row) places_.push_back(place(a.unknown, b.unknown));
    const linalg::Graph graph = linalg::graphOf(matrix_);
    factor_.analyze(graph, linalg::nestedDissection(graph));
  }

  bool factor(const Eigen::ArrayXd& weight) {
    double* numbers = matrix_.valuePtr();
    std::fill(numbers, numbers + matrix_.nonZeros(), 0.0);
    for (const int i : diagonal_) numbers[i] = hold_;
    const int* next = places_.data();
    for (std::size_t e = 0; e < G_.rows.size(); ++e)
      for (const auto& a : G_.rows[e])
        for (const auto& b : G_.rows[e])
          numbers[*next++] += weight[static_cast<Eigen::Index>(e)] * a.value * b.value;
    return static_cast<bool>(factor_.factor(matrix_));
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& rhs) const {
    return factor_.solve(Eigen::MatrixXd(rhs)).col(0);
  }

 private:
  int place(int row, int column) const {
    const int* begin = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column];
    const int* end = matrix_.innerIndexPtr() + matrix_.outerIndexPtr()[column + 1];
    return static_cast<int>(std::lower_bound(begin, end, row) - matrix_.innerIndexPtr());
  }

  const LengthRows& G_;
  const double hold_;
  Sparse matrix_;
  std::vector<int> diagonal_, places_;
  linalg::MultifrontalCholesky<double> factor_;
};

/// min ½ |y|² + ½ hold |x|² over t = G x + y − 1 ≥ 0, y ≥ 0: Mehrotra's predictor–corrector method.
class ShortfallFit {
 public:
  ShortfallFit(const LengthRows& G, double hold)
      : G_(G),
        hold_(hold),
        normal_(G, hold),
        x_(Eigen::VectorXd::Zero(G.unknowns)),
        y_(Eigen::ArrayXd::Ones(static_cast<Eigen::Index>(G.rows.size()))),
        t_(y_) {}

  /// max(0, 1 − G x) at the minimum.
  Eigen::VectorXd run() {
    // Without unknowns every edge is a point, whatever the map.
    for (int k = 0; k < kMaxIterations && x_.size() > 0; ++k) {
      const double mu = (t_ * y_).mean();
      pull_ = G_.transposedTimes(y_.matrix()) - hold_ * x_;
      gap_ = 1.0 - G_.times(x_).array() - y_ + t_;
      if (std::max({mu, gap_.abs().maxCoeff(), pull_.cwiseAbs().maxCoeff()}) < kAccuracy) break;
      if (!normal_.factor(y_ / (t_ + y_))) break;
      const Step affine = step(-t_ * y_);
      const double left = 1.0 - reach(affine, 1.0);
      const Step next = step(left * left * left * mu - t_ * y_ - affine.t * affine.y);
      const double length = std::min(1.0, reach(next, kStepToBoundary));
      x_ += length * next.x;
      y_ += length * next.y;
      t_ += length * next.t;
    }
    return (1.0 - G_.times(x_).array()).max(0.0);
  }

 private:
  struct Step {
    Eigen::VectorXd x;
    Eigen::ArrayXd y, t;
  };

  /// The step that changes t y by c and removes both residuals.
  Step step(const Eigen::ArrayXd& c) const {
    const Eigen::ArrayXd shift = (c + y_ * gap_) / (t_ + y_);
    Step step;
    step.x = normal_.solve(pull_ + G_.transposedTimes(shift.matrix()));
    const Eigen::ArrayXd lengths = G_.times(step.x);
    step.y = shift - y_ / (t_ + y_) * lengths;
    step.t = lengths + step.y - gap_;
    return step;
  }

  double reach(const Step& step, double share) const {
    double length = 1.0 / share;
    for (Eigen::Index e = 0; e < y_.size(); ++e) {
      if (step.y[e] < 0.0) length = std::min(length, -y_[e] / step.y[e]);
      if (step.t[e] < 0.0) length = std::min(length, -t_[e] / step.t[e]);
    }
    return share * length;
  }

  const LengthRows& G_;
  const double hold_;
  Normal normal_;
  Eigen::VectorXd x_;
  Eigen::ArrayXd y_, t_;  ///< shortfalls, and the slacks of t = G x + y − 1
  Eigen::VectorXd pull_;
  Eigen::ArrayXd gap_;
};

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
  const double hold = kHold * (1.0 + G.squaredNorm() / std::max(1, G.unknowns));
  const Eigen::VectorXd r = ShortfallFit(G, hold).run();
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
