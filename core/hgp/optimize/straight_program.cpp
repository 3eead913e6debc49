#include "hgp/optimize/straight_program.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"
#include "hgp/optimize/real_program.h"
#include "hgp/optimize/real_row.h"
#include "hgp/system/face_rows.h"
#include "hgp/system/square_rows.h"

namespace hgp {
namespace {

/// Triangles listed if a program is infeasible: at most this many, with duals of at least this share of the largest.
constexpr double kStraightConflictShare = 0.1;
constexpr std::size_t kStraightConflictCount = 50;
/// Stiffness that holds the map's translation in a covariance, relative to that of the distortion term.
constexpr double kFreeShare = 0.1;
/// Right-hand sides that are solved for together.
constexpr Eigen::Index kColumns = 64;

class StraightProgram {
 public:
  StraightProgram(const StraightSystem& in, const Frames& frames, const StraightOptions& options)
      : in_(in), s_(in.system), frames_(frames), o_(options) {
    index_.assign(at(in.unknowns.count), 0);
    given_.assign(index_.size(), 0.0);
    for (const auto& [unknown, value] : options.given) {
      index_[at(unknown)] = -1;
      given_[at(unknown)] = value;
    }
    for (const int part : {0, 1}) {
      origin_[at(part)] = originOf(part);
      if (options.given.empty() && origin_[at(part)] >= 0) index_[at(origin_[at(part)])] = -1;
    }
    for (int& p : index_) p = p < 0 ? -1 : count_++;
  }

  StraightResult run() {
    const bool isOdd = count_ % 2 != 0;
    squares_ = SquareRows<double>(count_ + isOdd);
    if (isOdd) {  // the constraints need pairs: one more unknown, which is 0
      squares_.add(count_, 1.0);
      squares_.endRow();
    }
    RealRow row(in_.unknowns, index_, given_);
    addHarmonic(row);
    addDistortion(row);
    addEdges(row);
    addFrames(row);
    program_.H = squares_.takeForm();
    program_.c = squares_.linear;
    const RealSolution found = solveReal(program_, orderUnknowns(), o_.progress);
    const socp::Solution& solution = found.solution;

    StraightResult result;
    result.status = solution.status;
    result.iterations = solution.iterations;
    result.multiplyAdds = found.multiplyAdds;
    result.x = Eigen::VectorXd::Zero(in_.unknowns.count);
    for (int i = 0; i < in_.unknowns.count; ++i)
      result.x[i] = index_[at(i)] >= 0 ? solution.x[index_[at(i)]] : given_[at(i)];
    result.z = placesOf(in_.unknowns, result.x);
    if (socp::isWithoutPoint(solution.status)) findConflict(solution, result);
    return result;
  }

  /// See straightCovariance.
  Eigen::MatrixXd covariance(const std::vector<int>& variables) {
    for (int& p : index_) p = 0;
    count_ = 0;
    for (int& p : index_) p = count_++;
    squares_ = SquareRows<double>(count_);
    RealRow row(in_.unknowns, index_, given_);
    addHarmonic(row);
    addDistortion(row);
    for (const int origin : origin_)
      if (origin >= 0) {
        const double nearly = kFreeShare * std::sqrt(o_.quality) * portable::exp(-o_.u[smallest_]);
        squares_.add(origin, nearly);
        squares_.endRow();
      }
    const Eigen::SparseMatrix<double> H = squares_.takeForm();
    linalg::MultifrontalCholesky<double> factor;
    factor.analyze(linalg::graphOf(H), orderUnknowns());
    if (!factor.factor(H)) return {};
    const auto n = static_cast<Eigen::Index>(variables.size());
    Eigen::MatrixXd out(n, n);
    for (Eigen::Index first = 0; first < n; first += kColumns) {
      const Eigen::Index some = std::min<Eigen::Index>(kColumns, n - first);
      Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(count_, some);
      for (Eigen::Index j = 0; j < some; ++j) unit(variables[at(first + j)], j) = 1.0;
      const Eigen::MatrixXd columns = factor.solve(unit);
      for (Eigen::Index j = 0; j < some; ++j)
        for (Eigen::Index i = 0; i < n; ++i) out(i, first + j) = columns(variables[at(i)], j);
    }
    return out;
  }

 private:
  double scaleAt(HalfedgeId h) const {
    return portable::exp(0.5 * (o_.u[s_.mesh.tail(h)] + o_.u[s_.mesh.head(h)]));
  }
  double faceScale(FaceId f) const {
    double sum = 0.0;
    for (VertexId v : s_.mesh.corners(f)) sum += o_.u[v] / 3.0;
    return portable::exp(sum);
  }
  int copyAt(FaceId f, int k) const { return s_.cut.copy[TriMesh::halfedge(f, k)].i; }

  /// The real (0) or imaginary (1) part of the vertex where the map is smallest: a translation of the whole map is
  /// free.
  int originOf(int part) {
    int best = -1;
    double smallest = 0.0;
    std::vector<double> scale(at(s_.unknowns.count), 0.0);
    std::vector<VertexId> vertex(at(s_.unknowns.count));
    for (VertexId v : s_.mesh.vertices())
      if (s_.unknowns.vertexUnknown[v] >= 0) {
        scale[at(s_.unknowns.vertexUnknown[v])] = o_.u[v];
        vertex[at(s_.unknowns.vertexUnknown[v])] = v;
      }
    for (int i = 0; i < in_.unknowns.count; ++i) {
      const int variable = in_.unknowns.variable[at(i)];
      if (variable % 2 != part || !vertex[at(variable / 2)].isValid()) continue;
      if (best >= 0 && scale[at(variable / 2)] >= smallest) continue;
      best = i;
      smallest = scale[at(variable / 2)];
    }
    if (best >= 0) smallest_ = vertex[at(in_.unknowns.variable[at(best)] / 2)];
    return best;
  }

  void endRow(RealRow& row) {
    squares_.endRow(row.take([&](int index, double value) { squares_.add(index, value); }));
  }

  void addHarmonic(RealRow& row) {
    const TriMesh& mesh = s_.mesh;
    for (VertexId v : mesh.vertices()) {
      if (!in_.hasRow[v]) continue;
      double total = 0.0;
      for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
        const CornerWeights w = meanValueWeights(s_.geometry, h);
        total += w.toHead + w.toThird;
      }
      const double weight = portable::exp(-o_.u[v]) / total;
      for (const int part : {0, 1}) {
        for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
          const CornerWeights w = meanValueWeights(s_.geometry, h);
          const Complex back = rotation(-s_.unknowns.turn[s_.cut.copy[h]], s_.seams.q);
          // The part of back · z: one part of z with a sign.
          const bool isReal = back.real() != 0.0;
          const int from = isReal ? part : 1 - part;
          const double sign = isReal ? back.real() : (part == 0 ? -back.imag() : back.imag());
          const auto add = [&](HalfedgeId corner, double factor) {
            row.add(s_.cut.copy[corner].i, from, sign * weight * factor);
          };
          add(h, w.toHead + w.toThird);
          add(TriMesh::next(h), -w.toHead);
          add(TriMesh::previous(h), -w.toThird);
        }
        endRow(row);
      }
    }
  }

  /// |f_z|² + |f_z̄|² = ½ (|∇u|² + |∇v|²): no row couples the two coordinates of a chart.
  void addDistortion(RealRow& row) {
    for (FaceId f : s_.mesh.faces()) {
      const LinearParts parts = linearParts(s_.geometry, f);
      const double target = std::sqrt(o_.quality * s_.geometry.area[f]);
      const double weight = target / faceScale(f);
      const Complex turn = portable::polar(weight * target, s_.seams.frameAngle[f]);
      for (int k = 0; k < 3; ++k) {
        const Complex similar = turn * parts.similarity[at(k)];
        row.add(copyAt(f, k), 0, -similar.real());
        row.add(copyAt(f, k), 1, similar.imag());
      }
      row.take([&](int index, double value) { squares_.linear[index] += value; });
      for (const int part : {0, 1})
        for (const int axis : {0, 1}) {
          for (int k = 0; k < 3; ++k) {
            const Complex gradient = 2.0 * parts.antisimilarity[at(k)];
            row.add(copyAt(f, k), part,
                    weight * std::sqrt(0.5) * (axis == 0 ? gradient.real() : gradient.imag()));
          }
          endRow(row);
        }
    }
  }

  /// Appends a constraint whose row r is filled by fill(r), a sum over the unknowns; false if none of them is free.
  template <class Fill>
  bool addConstraint(RealRow& row, int rowCount, const Eigen::Vector3d& h, const Fill& fill) {
    struct Entry {
      int row, index;
      double value;
    };
    std::vector<Entry> entries;
    std::vector<int> pairs;
    Eigen::Vector3d given = Eigen::Vector3d::Zero();
    for (int r = 0; r < rowCount; ++r) {
      fill(r);
      given[r] = row.take([&](int index, double value) {
        entries.push_back({r, index, value});
        pairs.push_back(index / 2);
      });
    }
    if (pairs.empty() && !o_.given.empty()) return false;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    socp::ConeConstraint constraint;
    constraint.F.setZero(3, static_cast<Eigen::Index>(2 * pairs.size()));
    constraint.h = h - given;
    for (const Entry& e : entries) {
      const auto pair = std::lower_bound(pairs.begin(), pairs.end(), e.index / 2) - pairs.begin();
      constraint.F(e.row, 2 * pair + e.index % 2) = e.value;
    }
    constraint.unknowns = std::move(pairs);
    program_.constraints.push_back(std::move(constraint));
    return true;
  }

  /// A linear inequality is a cone whose other two rows are empty.
  void addEdges(RealRow& row) {
    for (const StraightEdge& e : in_.edges) {
      const double scale = 1.0 / (scaleAt(e.h) * s_.geometry.length[e.h]);
      const double sign = e.heading < 2 ? scale : -scale;
      const bool isFree = addConstraint(row, 1, {o_.margin, 0.0, 0.0}, [&](int) {
        row.add(s_.cut.copy[TriMesh::next(e.h)].i, e.heading % 2, sign);
        row.add(s_.cut.copy[e.h].i, e.heading % 2, -sign);
      });
      if (isFree) edges_.push_back(e.h);
    }
    for (const SideDistance& d : in_.distances) {
      const double scale = 1.0 / (scaleAt(d.side) * d.length);
      const bool isFree =
          addConstraint(row, 1, {o_.margin, 0.0, 0.0}, [&](int) { row.add(d.sum, scale); });
      if (isFree) edges_.push_back(d.side);
    }
  }

  void addFrames(RealRow& row) {
    for (std::size_t j = 0; j < frames_.faces.size(); ++j) {
      const FaceId f = frames_.faces[j];
      const LinearParts parts = linearParts(s_.geometry, f);
      const double scale = 1.0 / faceScale(f);
      const Complex turn = portable::polar(scale, frames_.angles[j]);
      const bool isFree = addConstraint(row, 3, {o_.margin, 0.0, 0.0}, [&](int r) {
        for (int k = 0; k < 3; ++k) {
          // f_z d̄, then f_z̄: rows (Re, −Im) of a factor give a real part, (Im, Re) an imaginary part.
          const Complex factor =
              r == 0 ? turn * parts.similarity[at(k)] : scale * parts.antisimilarity[at(k)];
          row.add(copyAt(f, k), 0, r < 2 ? factor.real() : factor.imag());
          row.add(copyAt(f, k), 1, r < 2 ? -factor.imag() : factor.real());
        }
      });
      if (isFree) faces_.push_back(f);
    }
  }

  /// With the unknown that completes a pair.
  linalg::SeparatorTree orderUnknowns() const {
    linalg::SeparatorTree tree = in_.tree.get(s_, in_.unknowns, in_.hasRow, index_);
    if (squares_.linear.size() > count_) {
      tree.order.push_back(count_);
      ++tree.nodeStart.back();
    }
    return tree;
  }

  void findConflict(const socp::Solution& solution, StraightResult& result) const {
    const std::vector<std::size_t> order = stableOrder(
        solution.y.size(),
        [&](std::size_t a, std::size_t b) { return solution.y[a][0] > solution.y[b][0]; });
    for (const std::size_t b : order) {
      if (result.conflict.size() >= kStraightConflictCount ||
          solution.y[b][0] < kStraightConflictShare * solution.y[order[0]][0])
        break;
      const bool isEdge = b < edges_.size();
      if (isEdge) result.conflictEdges.push_back(edges_[b]);
      result.conflict.push_back(isEdge ? TriMesh::face(edges_[b]) : faces_[b - edges_.size()]);
    }
  }

  const StraightSystem& in_;
  const SeamlessSystem& s_;
  const Frames& frames_;
  const StraightOptions& o_;
  std::vector<int> index_;     ///< per real unknown; −1 where it is given
  std::vector<double> given_;  ///< per real unknown
  std::array<int, 2> origin_{-1, -1};
  VertexId smallest_;              ///< where the map is smallest
  std::vector<HalfedgeId> edges_;  ///< of the first constraints, sides of distances included
  std::vector<FaceId> faces_;      ///< of those after them
  int count_ = 0;                  ///< of unknowns that are not given
  SquareRows<double> squares_{0};
  RealProgram program_;
};

}  // namespace

Eigen::MatrixXd straightCovariance(const StraightSystem& straight, const StraightOptions& options,
                                   const std::vector<int>& variables) {
  const Frames none;
  return StraightProgram(straight, none, options).covariance(variables);
}

StraightResult solveStraight(const StraightSystem& straight, const Frames& frames,
                             const StraightOptions& options) {
  return StraightProgram(straight, frames, options).run();
}

}  // namespace hgp
