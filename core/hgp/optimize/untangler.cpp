#include "hgp/optimize/untangler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "hgp/base/portable_math.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/clique_sum.h"
#include "hgp/optimize/fold_barrier.h"

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
  Untangler(std::vector<UntangleFace> faces, int count, const UntangleOptions& options)
      : options_(options),
        count_(count),
        faces_(std::move(faces)),
        isBarrier_(faces_.size(), 0),
        hessian_(count) {
    analyze();
  }

  UntangleResult run(const Eigen::VectorXcd& start) {
    UntangleResult result;
    x_ = start;
    isFramed_ = true;
    for (int segment = 0, before = 0; segment < kMaxFramedSegments; ++segment) {
      std::fill(isBarrier_.begin(), isBarrier_.end(), char{0});
      if (!descend(result, kSegmentSteps)) break;
      if (result.flipped == 0) break;
      if (segment + 1 >= kFramedSegments && result.flipped > kWorthwhile * before) break;
      before = result.flipped;
      followMap();
    }
    isFramed_ = false;
    std::fill(isBarrier_.begin(), isBarrier_.end(), char{0});
    if (!result.isCancelled) descend(result, options_.maxIterations);
    result.flipped = extremes(x_).flipped;
    result.x = x_;
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
        for (const int g : faces_[i].beside) {
          if (g < 0) continue;
          sum += turn[static_cast<std::size_t>(g)];
          weight += 1.0;
        }
        next[i] = sum / weight;
      }
      turn.swap(next);
    }
    for (std::size_t i = 0; i < n; ++i) faces_[i].scale(portable::polar(1.0, -turn[i]), 1.0);
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

  using Face = UntangleFace;
  double epsilonOf(std::size_t face) const { return isBarrier_[face] != 0 ? 0.0 : epsilon_; }
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

  /// The pattern of the Hessian is that of the faces; both parts of an unknown stay together.
  void analyze() {
    for (const Face& face : faces_) {
      std::vector<int> unknowns;
      for (const Face::Term& term : face.terms) unknowns.push_back(term.unknown);
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
    similar = face.heldSimilar;
    anti = face.heldAnti;
    for (const Face::Term& term : face.terms) {
      const double re = x[term.unknown].real(), im = x[term.unknown].imag();
      similar += re * term.similar[0] + im * term.similar[1];
      anti += re * term.anti[0] + im * term.anti[1];
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
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      parts(faces_[f], x, similar, anti);
      const double D = areaOf(similar, 0.0) - std::norm(anti);
      e.least = std::min(e.least, D);
      e.flipped += !(D > 0.0);
      if (faces_[f].isKept && D > kMinBarrier) isBarrier_[f] = 1;
    }
    return e;
  }

  double energyOf(const Eigen::VectorXcd& x) const {
    double sum = 0.0;
    Complex similar, anti;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      parts(faces_[f], x, similar, anti);
      const double P = areaOf(similar, epsilonOf(f)), Q = std::norm(anti);
      if (isBarrier_[f] != 0 && !(P > Q)) return std::numeric_limits<double>::infinity();
      const double D = P - Q;
      sum += barrierValue(std::norm(similar) + Q, D, options_.scaleWeight, epsilonOf(f));
    }
    return sum;
  }

  /// Sets the Hessian to the sum of the faces' convexified ones, and returns the gradient.
  Eigen::VectorXd differentiate(const Eigen::VectorXcd& x) {
    Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * count_);
    hessian_.setZero();
    Eigen::MatrixXd J, K;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const std::vector<Face::Term>& terms = faces_[f].terms;
      const std::size_t n = terms.size();
      Complex similar, anti;
      parts(faces_[f], x, similar, anti);
      const double a = portable::abs(similar), b = portable::abs(anti);
      const Complex ra = a > 0.0 && !isFramed_ ? similar / a : Complex(1.0),
                    rb = b > 0.0 ? anti / b : Complex(1.0);
      Eigen::Vector4d slope;
      const Eigen::Matrix4d M =
          isFramed_ ? framedModel(similar, b, options_.scaleWeight, epsilonOf(f), slope)
                    : freeModel(a, b, options_.scaleWeight, epsilonOf(f), slope);
      // Rows: radial and tangential part of f_z, radial and tangential part of f_z̄.
      J.resize(4, static_cast<Eigen::Index>(2 * n));
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t part = 0; part < 2; ++part) {
          const Complex s = std::conj(ra) * terms[i].similar[part];
          const Complex t = std::conj(rb) * terms[i].anti[part];
          J.col(static_cast<Eigen::Index>(2 * i + part)) << s.real(), s.imag(), t.real(), t.imag();
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

  const UntangleOptions& options_;
  const int count_;
  std::vector<Face> faces_;
  std::vector<char> isBarrier_;  ///< kept, and positive by now
  CliqueSum hessian_;            ///< scaled by step()
  linalg::MultifrontalCholesky<double> factor_;
  Eigen::VectorXcd x_;
  double epsilon_ = 1.0;
  bool isFramed_ = false;
  int reported_ = -1;  ///< the last step reported to progress
};

}  // namespace

void UntangleFace::scale(const Complex& similarFactor, double antiFactor) {
  for (Term& term : terms)
    for (const std::size_t part : {0, 1}) {
      term.similar[part] *= similarFactor;
      term.anti[part] *= antiFactor;
    }
  heldSimilar *= similarFactor;
  heldAnti *= antiFactor;
}

UntangleFaces::UntangleFaces(const TriMesh& mesh, const UntangleOptions& options)
    : mesh_(mesh), options_(options), isKept_(at(mesh.faceCount()), 0) {
  for (const FaceId f : options.kept) isKept_[f] = 1;
}

void UntangleFaces::add(FaceId f, UntangleFace face, double frameAngle) {
  if (face.terms.empty()) return;
  double u = 0.0;
  for (const VertexId v : mesh_.corners(f)) u += options_.u[v] / 3.0;
  const double scale = portable::exp(-u);
  face.scale(portable::polar(scale, frameAngle), scale);
  face.isKept = isKept_[f] != 0;
  faces_.push_back(std::move(face));
  faceOf_.push_back(f);
}

std::vector<UntangleFace> UntangleFaces::take() {
  PerFace<int> number(at(mesh_.faceCount()), -1);
  for (std::size_t i = 0; i < faceOf_.size(); ++i) number[faceOf_[i]] = static_cast<int>(i);
  for (std::size_t i = 0; i < faceOf_.size(); ++i)
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId twin = mesh_.twin(TriMesh::halfedge(faceOf_[i], k));
      if (twin.isValid()) faces_[i].beside[at(k)] = number[TriMesh::face(twin)];
    }
  return std::move(faces_);
}

UntangleResult untangleFaces(std::vector<UntangleFace> faces, int count,
                             const Eigen::VectorXcd& start, const UntangleOptions& options) {
  return Untangler(std::move(faces), count, options).run(start);
}

}  // namespace hgp
