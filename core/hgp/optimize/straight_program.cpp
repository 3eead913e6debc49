#include "hgp/optimize/straight_program.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/real_form.h"
#include "hgp/system/face_rows.h"

namespace hgp {
namespace {

/// Triangles listed if a program is infeasible: at most this many, with duals of at least this share of the largest.
constexpr double kStraightConflictShare = 0.1;
constexpr std::size_t kStraightConflictCount = 50;

/// A sparse sum over the unknowns, collected term by term.
class RealRow {
 public:
  explicit RealRow(const RealUnknowns& unknowns, const std::vector<int>& place)
      : unknowns_(unknowns), place_(place), value_(place.size(), 0.0), isUsed_(place.size(), 0) {}

  /// Adds factor times the real (part 0) or imaginary part (1) of a copy.
  void add(int copy, int part, double factor) {
    for (RealUnknowns::Rows::InnerIterator it(unknowns_.rows, 2 * copy + part); it; ++it) {
      const auto i = static_cast<std::size_t>(it.col());
      if (place_[i] < 0) continue;  // held at 0
      if (!isUsed_[i]) {
        isUsed_[i] = 1;
        used_.push_back(static_cast<int>(i));
      }
      value_[i] += factor * it.value();
    }
  }
  /// Calls use(place, value) for every term, ascending, and clears the row.
  template <class Use>
  void take(const Use& use) {
    std::sort(used_.begin(), used_.end());
    for (const int unknown : used_) {
      const auto i = static_cast<std::size_t>(unknown);
      if (value_[i] != 0.0) use(place_[i], value_[i]);
      value_[i] = 0.0;
      isUsed_[i] = 0;
    }
    used_.clear();
  }

 private:
  const RealUnknowns& unknowns_;
  const std::vector<int>& place_;
  std::vector<double> value_;
  std::vector<char> isUsed_;
  std::vector<int> used_;
};

class StraightProgram {
 public:
  StraightProgram(const StraightSystem& in, const Frames& frames, const StraightOptions& options)
      : in_(in), s_(in.system), frames_(frames), o_(options) {
    place_.assign(at(in.unknowns.count), 0);
    hold(0);
    hold(1);
    for (int& p : place_) p = p < 0 ? -1 : count_++;
    padded_ = count_ + count_ % 2;
    c_ = Eigen::VectorXd::Zero(padded_);
  }

  StraightResult run() {
    RealRow row(in_.unknowns, place_);
    addHarmonic(row);
    addDistortion(row);
    addEdges(row);
    addFrames(row);
    Eigen::SparseMatrix<double> rows(rowCount_, count_);
    rows.setFromTriplets(entries_.begin(), entries_.end());
    entries_ = {};
    Eigen::SparseMatrix<double> H = rows.transpose() * rows;
    const linalg::SeparatorTree tree = orderUnknowns(H);
    RealForm form(std::move(H), tree, std::move(pairs_), std::move(used_));
    problem_.form = &form;
    problem_.c = c_;
    socp::SolveOptions solveOptions;
    solveOptions.progress = o_.progress;
    const socp::Solution solution = socp::solve(problem_, solveOptions);

    StraightResult result;
    result.status = solution.status;
    result.iterations = solution.iterations;
    result.work = form.multiplyAdds() * (solution.iterations + 2);
    result.x = Eigen::VectorXd::Zero(in_.unknowns.count);
    for (int i = 0; i < in_.unknowns.count; ++i)
      if (place_[at(i)] >= 0) result.x[i] = solution.x[place_[at(i)]];
    const Eigen::VectorXd parts = in_.unknowns.rows * result.x;
    for (Eigen::Index n = 0; n < parts.size(); n += 2)
      result.z.emplace_back(parts[n], parts[n + 1]);
    if (socp::isWithoutPoint(solution.status)) findConflict(solution, result);
    return result;
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

  /// Holds the real (0) or imaginary (1) part of the vertex where the map is smallest: a translation of the whole map is
  /// free.
  void hold(int part) {
    int best = -1;
    double smallest = 0.0;
    std::vector<double> scale(at(s_.unknowns.count), 0.0);
    std::vector<char> isVertex(at(s_.unknowns.count), 0);
    for (VertexId v : s_.mesh.vertices())
      if (s_.unknowns.vertexUnknown[v] >= 0) {
        scale[at(s_.unknowns.vertexUnknown[v])] = o_.u[v];
        isVertex[at(s_.unknowns.vertexUnknown[v])] = 1;
      }
    for (int i = 0; i < in_.unknowns.count; ++i) {
      const int variable = in_.unknowns.variable[at(i)];
      if (variable % 2 != part || !isVertex[at(variable / 2)]) continue;
      if (best >= 0 && scale[at(variable / 2)] >= smallest) continue;
      best = i;
      smallest = scale[at(variable / 2)];
    }
    if (best >= 0) place_[at(best)] = -1;
  }

  void endRow(RealRow& row, double constant = 0.0) {
    row.take([&](int place, double value) {
      entries_.emplace_back(rowCount_, place, value);
      c_[place] += value * constant;
    });
    ++rowCount_;
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
      row.take([&](int place, double value) { c_[place] += value; });
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

  /// Appends a constraint whose row r is filled by fill(r), a sum over the unknowns.
  template <class Fill>
  void addConstraint(RealRow& row, int rowCount, const Eigen::Vector3d& h, const Fill& fill) {
    struct Entry {
      int row, place;
      double value;
    };
    std::vector<Entry> entries;
    std::vector<int> pairs;
    for (int r = 0; r < rowCount; ++r) {
      fill(r);
      row.take([&](int place, double value) {
        entries.push_back({r, place, value});
        pairs.push_back(place / 2);
      });
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    socp::ConeConstraint constraint;
    constraint.F.setZero(3, static_cast<Eigen::Index>(2 * pairs.size()));
    constraint.h = h;
    std::vector<char> used(2 * pairs.size(), 0);
    for (const Entry& e : entries) {
      const auto pair = std::lower_bound(pairs.begin(), pairs.end(), e.place / 2) - pairs.begin();
      constraint.F(e.row, 2 * pair + e.place % 2) = e.value;
      used[at(2 * pair + e.place % 2)] = 1;
    }
    constraint.unknowns = pairs;
    problem_.constraints.push_back(std::move(constraint));
    pairs_.push_back(std::move(pairs));
    used_.push_back(std::move(used));
  }

  /// A linear inequality is a cone whose other two rows are empty.
  void addEdges(RealRow& row) {
    for (const StraightEdge& e : in_.edges) {
      const double scale = 1.0 / (scaleAt(e.h) * s_.geometry.length[e.h]);
      const double sign = e.heading < 2 ? scale : -scale;
      addConstraint(row, 1, {o_.margin, 0.0, 0.0}, [&](int) {
        row.add(s_.cut.copy[TriMesh::next(e.h)].i, e.heading % 2, sign);
        row.add(s_.cut.copy[e.h].i, e.heading % 2, -sign);
      });
    }
  }

  void addFrames(RealRow& row) {
    for (std::size_t j = 0; j < frames_.faces.size(); ++j) {
      const FaceId f = frames_.faces[j];
      const LinearParts parts = linearParts(s_.geometry, f);
      const double scale = 1.0 / faceScale(f);
      const Complex turn = portable::polar(scale, frames_.angles[j]);
      addConstraint(row, 3, {o_.margin, 0.0, 0.0}, [&](int r) {
        for (int k = 0; k < 3; ++k) {
          // f_z d̄, then f_z̄: rows (Re, −Im) of a factor give a real part, (Im, Re) an imaginary part.
          const Complex factor =
              r == 0 ? turn * parts.similarity[at(k)] : scale * parts.antisimilarity[at(k)];
          row.add(copyAt(f, k), 0, r < 2 ? factor.real() : factor.imag());
          row.add(copyAt(f, k), 1, r < 2 ? -factor.imag() : factor.real());
        }
      });
    }
  }

  linalg::SeparatorTree orderUnknowns(const Eigen::SparseMatrix<double>& H) const {
    return linalg::nestedDissection(linalg::graphOf(H));
  }

  void findConflict(const socp::Solution& solution, StraightResult& result) const {
    std::vector<std::size_t> order(solution.y.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return solution.y[a][0] > solution.y[b][0]; });
    for (const std::size_t b : order) {
      if (result.conflict.size() >= kStraightConflictCount ||
          solution.y[b][0] < kStraightConflictShare * solution.y[order[0]][0])
        break;
      const bool isEdge = b < in_.edges.size();
      if (isEdge) result.conflictEdges.push_back(in_.edges[b].h);
      result.conflict.push_back(isEdge ? TriMesh::face(in_.edges[b].h)
                                       : frames_.faces[b - in_.edges.size()]);
    }
  }

  const StraightSystem& in_;
  const SeamlessSystem& s_;
  const Frames& frames_;
  const StraightOptions& o_;
  std::vector<int> place_;  ///< per real unknown; −1 where it is held at 0
  int count_ = 0, padded_ = 0;
  Eigen::VectorXd c_;
  std::vector<Eigen::Triplet<double>> entries_;
  int rowCount_ = 0;
  socp::Problem problem_;
  std::vector<std::vector<int>> pairs_;
  std::vector<std::vector<char>> used_;
};

}  // namespace

StraightResult solveStraight(const StraightSystem& straight, const Frames& frames,
                             const StraightOptions& options) {
  return StraightProgram(straight, frames, options).run();
}

}  // namespace hgp
