#include "hgp/optimize/program.h"

#include <algorithm>
#include <numeric>

#include "hgp/base/check.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

/// Triangles named when a program is infeasible: those whose duals are within this share of the
/// largest, at most this many.
constexpr double kConflictShare = 0.1;
constexpr std::size_t kConflictCount = 50;

std::vector<FaceId> conflict(const Frames& frames, const socp::Solution& solution) {
  std::vector<std::size_t> order(frames.faces.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return solution.y[a][0] > solution.y[b][0]; });
  std::vector<FaceId> faces;
  for (std::size_t j : order) {
    if (faces.size() >= kConflictCount ||
        solution.y[j][0] < kConflictShare * solution.y[order[0]][0])
      break;
    faces.push_back(frames.faces[j]);
  }
  return faces;
}

}  // namespace

ProgramResult solveProgram(const TriMesh& mesh, const Geometry& geometry, const CutMesh& cut,
                           const SeamRotations& seams, const ReducedUnknowns& unknowns,
                           const HarmonicSystem& harmonic, const Frames& frames,
                           const ProgramOptions& options) {
  HGP_CHECK(frames.faces.size() == frames.angles.size(), "one direction per frame");
  const ProgramInput in{mesh, geometry, cut, seams, unknowns, harmonic, frames, options};
  const int pinned = pinnedUnknown(in);
  ProgramResult result;
  const std::unique_ptr<ProgramForm> form =
      options.isExact ? exactForm(in, pinned) : penaltyForm(in, pinned);
  if (!form) return result;
  linalg::PartialCholesky& cholesky = form->cholesky;
  const Eigen::VectorXcd reduced = cholesky.reduceLinear(form->c);

  socp::Problem problem;
  problem.form = &cholesky;
  problem.c = Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(reduced.data()),
                                                2 * reduced.size());
  FaceRows rows;
  for (std::size_t j = 0; j < frames.faces.size(); ++j) {
    faceRows(in, pinned, frames.faces[j], rows);
    problem.constraints.push_back(frameCondition(in, rows, j));
    for (int unknown : rows.unknowns)
      problem.constraints.back().unknowns.push_back(cholesky.dynamicIndex(form->place(unknown)));
  }
  socp::SolveOptions solveOptions;
  solveOptions.progress = options.progress;
  const socp::Solution solution = socp::solve(problem, solveOptions);

  result.status = solution.status;
  result.iterations = solution.iterations;
  const Eigen::VectorXcd full = form->expand(cholesky.extend(solution.x, form->c));
  const Eigen::VectorXcd z = unknowns.copies * full;
  result.z.assign(z.data(), z.data() + z.size());
  result.laplacianEnergy = (harmonic.rows * full).squaredNorm();
  if (solution.status == socp::SolveStatus::kInfeasible)
    result.conflict = conflict(frames, solution);
  return result;
}

}  // namespace hgp
