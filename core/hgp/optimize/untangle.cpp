#include "hgp/optimize/untangle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/clique_sum.h"
#include "hgp/optimize/fold_barrier.h"
#include "hgp/optimize/program_terms.h"

namespace hgp {
namespace {

/// ε never falls below this.
constexpr double kMinEpsilon = 1e-8;
/// A kept triangle is positive when D exceeds this.
constexpr double kMinBarrier = 1e-9;
/// Newton steps after the last flip, which move triangles away from degeneracy.
constexpr int kStepsAfter = 4;
/// The iteration ends after this many consecutive steps that reduce neither the number of flips nor the energy by this
/// fraction.
constexpr int kPatience = 12;
constexpr double kMinDecrease = 1e-4;
/// Newton steps with fixed frames, and how often the frames are then rotated towards the map.
constexpr int kSegmentSteps = 15;
constexpr int kFramedSegments = 8;
/// So many where each still leaves at most this share of the flips of the one before.
constexpr int kMaxFramedSegments = 16;
constexpr double kWorthwhile = 0.93;
/// Weight of a triangle's own direction relative to its neighbours' when frames follow the map, and
/// the number of Jacobi sweeps.
constexpr double kTrust = 0.02;
constexpr double kMinTrust = 1e-6;
constexpr int kSweeps = 200;

class Untangler {
 public:
  Untangler(const ProgramInput& in, const HeldUnknowns& held, const UntangleOptions& options)
      : in_(in), held_(held), options_(options), free_(held.isHeld), count_(free_.count()) {
    gatherFaces();
    analyze();
  }

  UntangleResult run(const Eigen::VectorXcd& start) {
    UntangleResult result;
    x_ = free_.gather(start);
    isFramed_ = true;
    for (int segment = 0, before = 0; segment < kMaxFramedSegments; ++segment) {
      for (Face& face : faces_) face.isBarrier = false;
      if (!descend(result, kSegmentSteps)) break;
      if (result.flipped == 0) break;
      if (segment + 1 >= kFramedSegments && result.flipped > kWorthwhile * before) break;
      before = result.flipped;
      followMap();
    }
    isFramed_ = false;
    for (Face& face : faces_) face.isBarrier = false;
    if (!result.isCancelled) descend(result, options_.maxIterations);
    result.flipped = extremes(x_).flipped;
    result.x = held_.value;
    free_.scatter(x_, result.x);
    return result;
  }

 private:
  /// Rotates the frames towards the map's own directions by angles that vary smoothly over the faces, so that
  /// no winding number changes.
  void followMap() {
    const std::size_t n = faces_.size();
    std::vector<double> misfit(n), trust(n);
    for (std::size_t i = 0; i < n; ++i) {
      Complex similar, anti;
      parts(faces_[i], x_, similar, anti);
      misfit[i] = portable::arg(similar);
      trust[i] =
          kTrust * std::clamp(1.0 - portable::abs(anti) / std::max(portable::abs(similar), 1e-300),
                              0.0, 1.0) +
          kMinTrust;
    }
    std::vector<double> turn(n, 0.0), next(n);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (std::size_t i = 0; i < n; ++i) {
        double sum = trust[i] * misfit[i], weight = trust[i];
        for (int g : beside_[i]) {
          if (g < 0) continue;
          sum += turn[static_cast<std::size_t>(g)];
          weight += 1.0;
        }
        next[i] = sum / weight;
      }
      turn.swap(next);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const Complex back = portable::polar(1.0, -turn[i]);
      faces_[i].rows.scale(back, 1.0);
    }
  }

  bool descend(UntangleResult& result, int steps) {
    Progress best{std::numeric_limits<int>::max(), 0.0, 0};
    int after = 0;
    const int end = result.iterations + steps;
    for (; result.iterations < end; ++result.iterations) {
      const Extremes now = extremes(x_);
      result.flipped = now.flipped;
      const bool isNew = std::exchange(reported_, result.iterations) != result.iterations;
      if (isNew && options_.progress &&
          !options_.progress(result.iterations, static_cast<double>(now.flipped) /
                                                    static_cast<double>(faces_.size()))) {
        result.isCancelled = true;
        return false;
      }
      if (now.flipped == 0 && ++after > (isFramed_ ? 0 : kStepsAfter)) break;
      epsilon_ = portable::hypot(kMinEpsilon, options_.epsilonShare * std::min(now.least, 0.0));
      const double energy = energyOf(x_);
      if (best.isStuck(now.flipped, energy)) break;
      if (!step(energy)) break;
    }
    return true;
  }

  struct Face {
    FaceRows rows;  ///< over numbers of free unknowns, in units of e^{u_f}
    bool isKept = false;
    bool isBarrier = false;  ///< kept, and positive by now
  };
  double epsilonOf(const Face& face) const { return face.isBarrier ? 0.0 : epsilon_; }
  struct Extremes {
    double least;  ///< smallest D
    int flipped;
  };
  struct Progress {
    int flipped;
    double energy;
    int waited;
    bool isStuck(int nowFlipped, double nowEnergy) {
      if (nowFlipped < flipped || nowEnergy < (1.0 - kMinDecrease) * energy) {
        flipped = std::min(flipped, nowFlipped);
        waited = 0;
      } else {
        ++waited;
      }
      energy = nowEnergy;
      return waited > kPatience;
    }
  };

  void gatherFaces() {
    PerFace<char> isKept(static_cast<std::size_t>(in_.mesh.faceCount()), 0);
    for (FaceId f : options_.kept) isKept[f] = 1;
    PerFace<int> number(static_cast<std::size_t>(in_.mesh.faceCount()), -1);
    FaceRows rows;
    for (FaceId f : in_.mesh.faces()) {
      faceRows(in_, held_, f, rows);
      if (rows.terms.empty()) continue;
      const double scale = portable::exp(-faceScale(in_, f));
      rows.scale(portable::polar(scale, in_.seams.frameAngle[f]), scale);
      for (FaceRows::Term& term : rows.terms) term.unknown = free_.number(term.unknown);
      number[f] = static_cast<int>(faces_.size());
      faces_.push_back({rows, isKept[f] != 0});
    }
    for (FaceId f : in_.mesh.faces()) {
      if (number[f] < 0) continue;
      std::array<int, 3> beside{-1, -1, -1};
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId twin = in_.mesh.twin(TriMesh::halfedge(f, k));
        if (twin.isValid()) beside[static_cast<std::size_t>(k)] = number[TriMesh::face(twin)];
      }
      beside_.push_back(beside);
    }
  }

  /// The pattern of the Hessian is that of the faces; both parts of an unknown stay together.
  void analyze() {
    for (const Face& face : faces_) {
      std::vector<int> unknowns;
      for (const FaceRows::Term& term : face.rows.terms) unknowns.push_back(term.unknown);
      hessian_.addClique(std::move(unknowns));
    }
    linalg::SeparatorTree tree = linalg::nestedDissection(linalg::graphOf(hessian_.couples()));
    std::vector<int> order;
    for (int unknown : tree.order) {
      order.push_back(2 * unknown);
      order.push_back(2 * unknown + 1);
    }
    tree.order = std::move(order);
    for (int& start : tree.nodeStart) start *= 2;
    hessian_.analyze();
    factor_.analyze(linalg::graphOf(hessian_.matrix()), tree);
  }

  static void parts(const Face& face, const Eigen::VectorXcd& x, Complex& similar, Complex& anti) {
    similar = face.rows.heldSimilar;
    anti = face.rows.heldAnti;
    for (const FaceRows::Term& term : face.rows.terms) {
      similar += term.similar * x[term.unknown];
      anti += term.anti * x[term.unknown];
    }
  }

  /// |f_z|² or, with frames, framedArea of the part along the frame.
  double areaOf(Complex similar, double epsilon) const {
    return isFramed_ ? framedArea(similar.real(), epsilon).value : std::norm(similar);
  }

  /// Also sets which faces are barriers from now on.
  Extremes extremes(const Eigen::VectorXcd& x) {
    Extremes e{std::numeric_limits<double>::max(), 0};
    Complex similar, anti;
    for (Face& face : faces_) {
      parts(face, x, similar, anti);
      const double D = areaOf(similar, 0.0) - std::norm(anti);
      e.least = std::min(e.least, D);
      e.flipped += !(D > 0.0);
      face.isBarrier = face.isBarrier || (face.isKept && D > kMinBarrier);
    }
    return e;
  }

  double energyOf(const Eigen::VectorXcd& x) const {
    double sum = 0.0;
    Complex similar, anti;
    for (const Face& face : faces_) {
      parts(face, x, similar, anti);
      const double P = areaOf(similar, epsilonOf(face)), Q = std::norm(anti);
      if (face.isBarrier && !(P > Q)) return std::numeric_limits<double>::infinity();
      const double D = P - Q;
      sum += barrierValue(std::norm(similar) + Q, D, options_.scaleWeight, epsilonOf(face));
    }
    return sum;
  }

  /// Sets the Hessian to the sum of the faces' convexified ones, and returns the gradient.
  Eigen::VectorXd differentiate(const Eigen::VectorXcd& x) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * count_);
    hessian_.setZero();
    Eigen::MatrixXd J, K;
    for (const Face& face : faces_) {
      const std::vector<FaceRows::Term>& terms = face.rows.terms;
      const std::size_t n = terms.size();
      Complex similar, anti;
      parts(face, x, similar, anti);
      const double a = portable::abs(similar), b = portable::abs(anti);
      const Complex ra = a > 0.0 && !isFramed_ ? similar / a : Complex(1.0),
                    rb = b > 0.0 ? anti / b : Complex(1.0);
      Eigen::Vector4d slope;
      const Eigen::Matrix4d M =
          isFramed_ ? framedModel(similar, b, options_.scaleWeight, epsilonOf(face), slope)
                    : freeModel(a, b, options_.scaleWeight, epsilonOf(face), slope);
      // Rows: radial and tangential part of f_z, radial and tangential part of f_z̄.
      J.resize(4, static_cast<Eigen::Index>(2 * n));
      for (std::size_t i = 0; i < n; ++i) {
        const Complex s = std::conj(ra) * terms[i].similar, t = std::conj(rb) * terms[i].anti;
        const auto column = static_cast<Eigen::Index>(2 * i);
        J.col(column) << s.real(), s.imag(), t.real(), t.imag();
        J.col(column + 1) << -s.imag(), s.real(), -t.imag(), t.real();
      }
      for (std::size_t i = 0; i < n; ++i)
        for (int part = 0; part < 2; ++part) {
          const auto column = static_cast<Eigen::Index>(2 * i) + part;
          gradient[2 * terms[i].unknown + part] += slope.dot(J.col(column));
        }
      K.noalias() = J.transpose() * (M * J);
      hessian_.add(K);
    }
    return gradient;
  }

  /// One Newton step with backtracking; false if no step length lowers the energy.
  bool step(double energy) {
    const Eigen::VectorXd gradient = differentiate(x_);
    Eigen::SparseMatrix<double>& H = hessian_.matrix();
    // Scaled to a unit diagonal: if scales differ by e^20, a shift suited to the largest would dominate the smallest.
    const Eigen::VectorXd scale = H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    for (int column = 0; column < H.cols(); ++column)
      for (Eigen::SparseMatrix<double>::InnerIterator it(H, column); it; ++it)
        it.valueRef() = scale[it.row()] * it.value() * scale[column];
    bool isFactored = false;
    for (double lift = 1e-12; !isFactored && lift < 1.0; lift *= 1e3)
      isFactored = static_cast<bool>(factor_.factor(H, lift));
    if (!isFactored) return false;
    const Eigen::VectorXd scaled = -scale.cwiseProduct(gradient);
    const Eigen::VectorXd d = scale.cwiseProduct(factor_.solve(Eigen::MatrixXd(scaled)).col(0));
    const double slope = gradient.dot(d);
    if (!(slope < 0.0)) return false;
    const Eigen::VectorXcd direction =
        Eigen::Map<const Eigen::VectorXcd>(reinterpret_cast<const Complex*>(d.data()), count_);
    for (double t = 1.0; t > 1e-9; t *= 0.5) {
      const Eigen::VectorXcd moved = x_ + t * direction;
      if (energyOf(moved) <= energy + 1e-4 * t * slope) {
        x_ = moved;
        return true;
      }
    }
    return false;
  }

  const ProgramInput& in_;
  const HeldUnknowns& held_;
  const UntangleOptions& options_;
  const FreeUnknowns free_;
  const int count_;
  std::vector<Face> faces_;
  std::vector<std::array<int, 3>> beside_;  ///< neighbours of each face, −1: none
  CliqueSum hessian_{count_};               ///< scaled by step()
  linalg::MultifrontalCholesky<double> factor_;
  Eigen::VectorXcd x_;
  double epsilon_ = 1.0;
  bool isFramed_ = false;
  int reported_ = -1;  ///< the last step reported to progress
};

}  // namespace

UntangleResult untangle(const SeamlessSystem& system, const Eigen::VectorXcd& x,
                        const UntangleOptions& options) {
  const Frames none;
  ProgramOptions program;
  program.u = options.u;
  const ProgramInput in{system, none, program};
  HeldUnknowns held = heldUnknowns(in);
  held.value = x;
  return Untangler(in, held, options).run(x);
}

}  // namespace hgp
