#include "hgp/optimize/program.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "hgp/base/check.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

/// Triangles named when a program is infeasible: those whose duals are within this share of the
/// largest, at most this many.
constexpr double kConflictShare = 0.1;
constexpr std::size_t kConflictCount = 50;

class ProgramBuilder {
 public:
  ProgramBuilder(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                 const SeamRotations& seams, const ReducedUnknowns& unknowns,
                 const HarmonicSystem& harmonic, const Frames& frames,
                 const ProgramOptions& options)
      : mesh_(mesh),
        geometry_(geometry),
        cut_(cut),
        seams_(seams),
        unknowns_(unknowns),
        harmonic_(harmonic),
        frames_(frames),
        o_(options) {}

  ProgramResult run() {
    pinned_ = choosePinned();
    assembleForm();
    ProgramResult result;
    linalg::PartialCholesky form;
    if (!form.build(H_, cliques())) return result;
    const Eigen::VectorXcd reduced = form.reduceLinear(c_);

    socp::Problem problem;
    problem.form = &form;
    problem.c = Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(reduced.data()),
                                                  2 * reduced.size());
    for (std::size_t j = 0; j < frames_.faces.size(); ++j)
      problem.constraints.push_back(frameCondition(j, form));
    socp::SolveOptions solveOptions;
    solveOptions.progress = o_.progress;
    const socp::Solution solution = socp::solve(problem, solveOptions);

    result.status = solution.status;
    result.iterations = solution.iterations;
    const Eigen::VectorXcd x = form.extend(solution.x, c_);
    Eigen::VectorXcd full(unknowns_.count);
    for (int i = 0; i < unknowns_.count; ++i) full[i] = i == pinned_ ? 0.0 : x[index(i)];
    const Eigen::VectorXcd z = unknowns_.copies * full;
    result.z.assign(z.data(), z.data() + z.size());
    result.laplacianEnergy = (harmonic_.rows * full).squaredNorm();
    if (solution.status == socp::SolveStatus::kInfeasible) result.conflict = conflict(solution);
    return result;
  }

 private:
  /// Unknowns without the pinned one.
  int index(int unknown) const { return unknown - (pinned_ >= 0 && unknown > pinned_ ? 1 : 0); }

  /// Translations of the whole map are free: hold one vertex of a constrained triangle at 0.
  int choosePinned() const {
    for (FaceId f : frames_.faces)
      for (VertexId v : mesh_.corners(f))
        if (unknowns_.vertexUnknown[v] >= 0) return unknowns_.vertexUnknown[v];
    for (VertexId v : mesh_.vertices())
      if (unknowns_.vertexUnknown[v] >= 0) return unknowns_.vertexUnknown[v];
    // Every vertex is a cone that its chains decide: moving the map changes the translation of each
    // chain that rotates, so one of those is held.
    for (std::size_t c = 0; c < cut_.chains.size(); ++c)
      if (unknowns_.chainUnknown[c] >= 0 && seams_.rotation[cut_.chains[c].left[0]] != 0)
        return unknowns_.chainUnknown[c];
    return -1;
  }

  double faceScale(FaceId f) const {
    double sum = 0.0;
    for (VertexId v : mesh_.corners(f)) sum += o_.u[v] / 3.0;
    return sum;
  }

  /// H = Σ rows, and c from the distortion term: ½ xᴴHx + Re(cᴴx).
  void assembleForm() {
    const int n = unknowns_.count - (pinned_ >= 0 ? 1 : 0);
    c_ = Eigen::VectorXcd::Zero(n);
    // All terms as rows: harmonic rows first, two rows per face of the distortion term behind.
    const double delta = std::max(o_.quality, o_.tieBreak);
    std::vector<Eigen::Triplet<Complex>> entries;
    const auto harmonicRows = harmonic_.rows.rows();
    entries.reserve(static_cast<std::size_t>(harmonic_.rows.nonZeros()));
    for (Eigen::Index r = 0; r < harmonicRows; ++r) {
      const double weight = std::exp(-o_.u[harmonic_.rowVertex[static_cast<std::size_t>(r)]]);
      for (SparseRows::InnerIterator it(harmonic_.rows, r); it; ++it)
        if (it.col() != pinned_)
          entries.emplace_back(static_cast<int>(r), index(static_cast<int>(it.col())),
                               weight * it.value());
    }
    int row = static_cast<int>(harmonicRows);
    if (delta > 0.0)
      for (FaceId f : mesh_.faces()) row = addDistortion(f, delta, row, entries);
    SparseC rows(row, n);
    rows.setFromTriplets(entries.begin(), entries.end());
    H_ = rows.adjoint() * rows;
  }

  int addDistortion(FaceId f, double delta, int row,
                    std::vector<Eigen::Triplet<Complex>>& entries) {
    const LinearParts parts = linearParts(geometry_, f);
    const double weight = std::sqrt(delta * geometry_.area[f]) * std::exp(-faceScale(f));
    const Complex turn = std::polar(1.0, seams_.frameAngle[f]);
    const double target = std::sqrt(delta * geometry_.area[f]);  // weight · e^u
    for (int k = 0; k < 3; ++k) {
      const CutVertexId copy = cut_.copy[TriMesh::halfedge(f, k)];
      for (SparseRows::InnerIterator it(unknowns_.copies, copy.i); it; ++it) {
        if (it.col() == pinned_) continue;
        const int column = index(static_cast<int>(it.col()));
        const Complex similar =
            weight * turn * parts.similarity[static_cast<std::size_t>(k)] * it.value();
        entries.emplace_back(row, column, similar);
        entries.emplace_back(
            row + 1, column,
            weight * parts.antisimilarity[static_cast<std::size_t>(k)] * it.value());
        c_[column] -= std::conj(similar) * target;
      }
    }
    return row + 2;
  }

  /// Unknowns of each frame's triangle, ascending.
  std::vector<std::vector<int>> cliques() const {
    std::vector<std::vector<int>> result;
    for (FaceId f : frames_.faces) result.push_back(unknownsOf(f));
    return result;
  }
  std::vector<int> unknownsOf(FaceId f) const {
    std::vector<int> list;
    for (int k = 0; k < 3; ++k)
      for (SparseRows::InnerIterator it(unknowns_.copies, cut_.copy[TriMesh::halfedge(f, k)].i); it;
           ++it)
        if (it.col() != pinned_) list.push_back(index(static_cast<int>(it.col())));
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
  }

  /// s = (Re(f_z d̄) − ε, Re f_z̄, Im f_z̄), divided by the local scale e^u.
  socp::ConeConstraint frameCondition(std::size_t j, const linalg::PartialCholesky& form) const {
    const FaceId f = frames_.faces[j];
    const std::vector<int> list = unknownsOf(f);
    const LinearParts parts = linearParts(geometry_, f);
    const double scale = std::exp(-faceScale(f));
    const Complex turn = std::polar(1.0, frames_.angles[j]);
    std::vector<Complex> similar(list.size()), anti(list.size());
    for (int k = 0; k < 3; ++k) {
      const CutVertexId copy = cut_.copy[TriMesh::halfedge(f, k)];
      for (SparseRows::InnerIterator it(unknowns_.copies, copy.i); it; ++it) {
        if (it.col() == pinned_) continue;
        const auto at = static_cast<std::size_t>(
            std::lower_bound(list.begin(), list.end(), index(static_cast<int>(it.col()))) -
            list.begin());
        similar[at] += scale * turn * parts.similarity[static_cast<std::size_t>(k)] * it.value();
        anti[at] += scale * parts.antisimilarity[static_cast<std::size_t>(k)] * it.value();
      }
    }
    socp::ConeConstraint constraint;
    constraint.F.resize(3, static_cast<Eigen::Index>(2 * list.size()));
    for (std::size_t i = 0; i < list.size(); ++i) {
      constraint.unknowns.push_back(form.dynamicIndex(list[i]));
      const auto column = static_cast<Eigen::Index>(2 * i);
      constraint.F.col(column) << similar[i].real(), anti[i].real(), anti[i].imag();
      constraint.F.col(column + 1) << -similar[i].imag(), -anti[i].imag(), anti[i].real();
    }
    constraint.h[0] = o_.margin;
    return constraint;
  }

  std::vector<FaceId> conflict(const socp::Solution& solution) const {
    std::vector<std::size_t> order(frames_.faces.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return solution.y[a][0] > solution.y[b][0]; });
    std::vector<FaceId> faces;
    for (std::size_t j : order) {
      if (faces.size() >= kConflictCount ||
          solution.y[j][0] < kConflictShare * solution.y[order[0]][0])
        break;
      faces.push_back(frames_.faces[j]);
    }
    return faces;
  }

  const TriMesh& mesh_;
  const Geometry& geometry_;
  const CutMesh& cut_;
  const SeamRotations& seams_;
  const ReducedUnknowns& unknowns_;
  const HarmonicSystem& harmonic_;
  const Frames& frames_;
  const ProgramOptions& o_;
  int pinned_ = -1;
  SparseC H_;
  Eigen::VectorXcd c_;
};

}  // namespace

ProgramResult solveProgram(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                           const SeamRotations& seams, const ReducedUnknowns& unknowns,
                           const HarmonicSystem& harmonic, const Frames& frames,
                           const ProgramOptions& options) {
  HGP_CHECK(frames.faces.size() == frames.angles.size(), "one direction per frame");
  return ProgramBuilder(mesh, geometry, cut, seams, unknowns, harmonic, frames, options).run();
}

}  // namespace hgp
