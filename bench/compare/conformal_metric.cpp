#include "conformal_metric.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <limits>

#include "processor_time.h"

namespace hgp::bench {
namespace {

/// A step is accepted if E still decreases at its end, or increases with at most this fraction of the initial slope.
constexpr double kLargestRise = 0.1;
constexpr double kShortestNewtonStep = 1e-12;
/// Below this residual, a step that does not halve it is the last: the rest is rounding.
constexpr double kRounding = 1e-9;
/// Fraction of the mean diagonal that is added to rows left empty by broken triangles.
constexpr double kRegular = 1e-9;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The angles of a triangle, per corner; false if the triangle inequality is violated.
bool cornerAngles(const std::array<double, 3>& opposite, std::array<double, 3>& angle) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = opposite[k], b = opposite[(k + 1) % 3], c = opposite[(k + 2) % 3];
    if (a < b + c) continue;
    angle = {0.0, 0.0, 0.0};
    angle[k] = kPi;
    return false;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = opposite[k], b = opposite[(k + 1) % 3], c = opposite[(k + 2) % 3];
    angle[k] = 2.0 * std::atan2(std::sqrt((a - b + c) * (a + b - c)),
                                std::sqrt((a + b + c) * (b + c - a)));
  }
  return true;
}

class Energy {
 public:
  Energy(const TriMesh& mesh, const Geometry& geometry, const Topology& topology,
         const FilledSurface& surface, const CompleteSpec& spec)
      : mesh_(mesh), geometry_(geometry), surface_(surface), angle_(at(mesh.faceCount())) {
    asked_ = Eigen::VectorXd::Constant(surface.nodeCount, 2.0 * kPi);
    for (const ConePoint& cone : spec.cones)
      asked_[surface.node[cone.vertex]] = turnAngle(cone.k, spec.q);
    for (std::size_t j = 0; j < topology.loops.size(); ++j)
      asked_[surface.loopNode[j]] = kPi * static_cast<double>(topology.loops[j].halfedges.size()) -
                                    turnAngle(spec.turning[j], spec.q);
  }

  /// ∂E/∂u; also sets the angles from which the Hessian is computed.
  Eigen::VectorXd gradient(const Eigen::VectorXd& u) {
    Eigen::VectorXd g = asked_;
    broken_ = 0;
    for (FaceId f : mesh_.faces()) {
      std::array<double, 3>& angle = angle_[f];
      broken_ += !cornerAngles(oppositeLengths(u, f), angle);
      for (int k = 0; k < 3; ++k) g[nodeOf(f, k)] -= angle[at(k)];
    }
    return g;
  }
  int broken() const { return broken_; }

  /// The Hessian over all nodes except the first, which is held fixed because E is invariant under scaling.
  Eigen::SparseMatrix<double> hessian() const {
    const int n = surface_.nodeCount - 1;
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(12 * at(mesh_.faceCount()) + at(n));
    double trace = 0.0;
    for (FaceId f : mesh_.faces())
      for (int k = 0; k < 3; ++k) {
        // Broken triangles keep their entries in the sparsity pattern.
        const double alpha = angle_[f][at(k)];
        const bool isBroken = alpha <= 0.0 || alpha >= kPi;
        const double w = isBroken ? 0.0 : 0.5 / std::tan(alpha);
        const int i = nodeOf(f, (k + 1) % 3) - 1, j = nodeOf(f, (k + 2) % 3) - 1;
        if (i == j) continue;
        if (i >= 0) entries.emplace_back(i, i, w);
        if (j >= 0) entries.emplace_back(j, j, w);
        if (i >= 0 && j >= 0) entries.emplace_back(std::max(i, j), std::min(i, j), -w);
        trace += 2.0 * w;
      }
    const double regular = broken_ > 0 ? kRegular * trace / std::max(1, n) : 0.0;
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, regular);
    Eigen::SparseMatrix<double> h(n, n);
    h.setFromTriplets(entries.begin(), entries.end());
    return h;
  }

  /// The lengths l̃ for u.
  PerHalfedge<double> lengths(const Eigen::VectorXd& u) const {
    PerHalfedge<double> length = geometry_.length;
    for (FaceId f : mesh_.faces())
      for (int k = 0; k < 3; ++k)
        length[TriMesh::halfedge(f, k)] *=
            std::exp(0.5 * (u[nodeOf(f, k)] + u[nodeOf(f, (k + 1) % 3)]));
    return length;
  }

 private:
  int nodeOf(FaceId f, int k) const { return surface_.node[mesh_.tail(TriMesh::halfedge(f, k))]; }

  /// Lengths opposite to corners 0, 1 and 2, up to a common factor, because e^u may exceed the range of doubles.
  std::array<double, 3> oppositeLengths(const Eigen::VectorXd& u, FaceId f) const {
    std::array<double, 3> opposite{};
    const double middle = (u[nodeOf(f, 0)] + u[nodeOf(f, 1)] + u[nodeOf(f, 2)]) / 3.0;
    for (int k = 0; k < 3; ++k) {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      opposite[at(k)] = geometry_.length[TriMesh::halfedge(f, i)] *
                        std::exp(0.5 * (u[nodeOf(f, i)] + u[nodeOf(f, j)]) - middle);
    }
    return opposite;
  }

  const TriMesh& mesh_;
  const Geometry& geometry_;
  const FilledSurface& surface_;
  Eigen::VectorXd asked_;
  PerFace<std::array<double, 3>> angle_;
  int broken_ = 0;
};

/// Moves along `change` while E decreases; false if no step is short enough. Leaves the
/// energy's angles at the new u.
bool descend(Energy& energy, const Eigen::VectorXd& change, Eigen::VectorXd& u,
             Eigen::VectorXd& gradient) {
  const double first = gradient.dot(change);
  if (!(first < 0.0)) return false;
  for (double step = 1.0; step > kShortestNewtonStep; step *= 0.5) {
    const Eigen::VectorXd trial = u + step * change;
    const Eigen::VectorXd there = energy.gradient(trial);
    if (!(there.dot(change) <= -kLargestRise * first)) continue;
    u = trial;
    gradient = there;
    return true;
  }
  return false;
}

}  // namespace

ConformalMetric conformalMetric(const TriMesh& mesh, const Geometry& geometry,
                                const Topology& topology, const FilledSurface& surface,
                                const CompleteSpec& spec, const ConformalOptions& options) {
  const double began = processorSeconds();
  Energy energy(mesh, geometry, topology, surface, spec);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(surface.nodeCount);
  Eigen::VectorXd gradient = energy.gradient(u);
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver;
  ConformalMetric metric;
  const auto residual = [&] { return gradient.cwiseAbs().maxCoeff(); };
  double last = std::numeric_limits<double>::infinity();
  for (; metric.steps < options.maxSteps && residual() > options.tolerance; ++metric.steps) {
    if (residual() < kRounding && residual() > 0.5 * last) break;
    last = residual();
    metric.isLate = options.maxSeconds > 0.0 && processorSeconds() - began > options.maxSeconds;
    if (metric.isLate) break;
    const Eigen::SparseMatrix<double> hessian = energy.hessian();
    if (metric.steps == 0) solver.analyzePattern(hessian);
    solver.factorize(hessian);
    if (solver.info() != Eigen::Success) break;
    Eigen::VectorXd change = Eigen::VectorXd::Zero(u.size());
    change.tail(u.size() - 1) = solver.solve(-gradient.tail(u.size() - 1));
    if (!change.allFinite() || !descend(energy, change, u, gradient)) break;
  }
  gradient = energy.gradient(u);
  metric.residual = residual();
  metric.broken = energy.broken();
  metric.isFound = metric.residual <= std::max(options.tolerance, kRounding) && metric.broken == 0;
  metric.length = energy.lengths(u);
  return metric;
}

}  // namespace hgp::bench
