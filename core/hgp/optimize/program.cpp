#include "hgp/optimize/program.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/check.h"
#include "hgp/base/portable_math.h"
#include "hgp/base/stable_order.h"
#include "hgp/linalg/factor/factor.h"
#include "hgp/optimize/harmonic_basis.h"
#include "hgp/optimize/nearest_harmonic.h"
#include "hgp/optimize/program_form.h"

namespace hgp {
namespace {

/// Triangles listed if a program has no point: those whose duals are at least this fraction of the
/// largest, at most this many.
constexpr double kConflictShare = 0.1;
constexpr std::size_t kConflictCount = 50;

/// Maximum number of proximal steps, the relative change that ends them, and the fraction of the harmonic energy
/// below which it counts as zero.
constexpr int kProximalSteps = 8;
constexpr double kProximalChange = 1e-13;
constexpr double kVanishedEnergy = 1e-6;

std::vector<FaceId> strainedMost(const Frames& frames, const socp::Solution& solution) {
  const std::vector<std::size_t> order = stableOrder(
      frames.faces.size(),
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

/// Half the gradient of ‖D L z‖² in the form's unknowns, and the energy itself.
double harmonicGradient(const ProgramInput& in, const ProgramForm& form, const Eigen::VectorXcd& x,
                        const HeldUnknowns& held, Eigen::VectorXcd& gradient) {
  Eigen::VectorXcd residual = in.harmonic.rows * form.expand(x);
  double energy = 0.0;
  for (Eigen::Index r = 0; r < residual.size(); ++r) {
    const VertexId v = in.harmonic.rowVertex[static_cast<std::size_t>(r)];
    const double weight = portable::exp(-2.0 * in.options.u[v]);
    energy += weight * std::norm(residual[r]);
    residual[r] *= weight;
  }
  const Eigen::VectorXcd all = in.harmonic.rows.adjoint() * residual;
  gradient = Eigen::VectorXcd::Zero(x.size());
  for (int unknown = 0; unknown < in.unknowns.count; ++unknown)
    if (!held.isHeld[static_cast<std::size_t>(unknown)])
      gradient[form.number(unknown)] = all[unknown];
  return energy;
}

/// The tie-break selects one of several exactly harmonic maps, but also moves the map away from them by O(δ). Each
/// proximal step (the minimiser with the distortion term relative to the last map instead of the frames)
/// reduces that by a constant factor. If the energy does not vanish, x is unchanged:
/// there is no exactly harmonic map, and the steps would only shrink it.
/// @param root  the solution of the reduced problem
/// @return all unknowns
Eigen::VectorXcd withoutTieBreak(const ProgramInput& in, const ProgramForm& form,
                                 const HeldUnknowns& held, const socp::Problem& problem,
                                 Eigen::VectorXd root) {
  Eigen::VectorXcd x = form.cholesky.extend(root, form.c), moved = x, gradient;
  double first = -1.0;
  for (int step = 0; step <= kProximalSteps; ++step) {
    const double energy = harmonicGradient(in, form, moved, held, gradient);
    if (step == 0) first = energy;
    if (energy <= kVanishedEnergy * first) x = moved;
    const Eigen::VectorXd change =
        form.cholesky.solve(Eigen::VectorXd(-socp::reducedLinear(form.cholesky, gradient)));
    root += change;
    if (!root.allFinite() || !socp::isFulfilled(problem, root)) break;
    const Eigen::VectorXcd all = form.cholesky.extend(change, gradient);
    moved += all;
    if (all.norm() <= kProximalChange * moved.norm()) break;
  }
  return form.expand(x);
}

}  // namespace

ProgramResult solveProgram(const SeamlessSystem& system, const Frames& frames,
                           const ProgramOptions& options) {
  HGP_CHECK(frames.faces.size() == frames.angles.size(), "one direction per frame");
  const ProgramInput in{system, frames, options};
  HeldUnknowns held = heldUnknowns(in);
  ProgramResult result;
  const auto* penalty = std::get_if<PenaltyObjective>(&options.objective);
  const auto* harmonic = std::get_if<HarmonicObjective>(&options.objective);
  const std::unique_ptr<ProgramForm> form =
      penalty    ? penaltyForm(in, *penalty, held)
      : harmonic ? harmonicForm(in, *harmonic)
                 : exactForm(in, std::get<ExactObjective>(options.objective), held);
  if (!form) return result;
  if (harmonic) held.isHeld.assign(held.isHeld.size(), 0);  // the basis holds one itself
  linalg::PartialCholesky& cholesky = form->cholesky;

  socp::Problem problem = socp::problemOver(cholesky, form->c);
  problem.sharesBlock = form->isDense() && !frames.faces.empty();
  FaceRows rows;
  for (std::size_t j = 0; j < frames.faces.size(); ++j) {
    faceRows(in, held, frames.faces[j], rows);
    form->rewrite(rows);
    socp::append(frameCondition(in, rows, j), rows.unknowns(), cholesky, problem);
  }
  socp::SolveOptions solveOptions;
  solveOptions.progress = options.progress;
  const socp::Solution solution = socp::solve(problem, solveOptions);

  result.status = solution.status;
  result.iterations = solution.iterations;
  result.multiplyAdds = linalg::multiplyAdds(cholesky.report(), std::max(1, solution.iterations)) +
                        (harmonic ? harmonic->basis->multiplyAdds() : 0.0);
  const bool isTieBroken = penalty && penalty->quality == 0.0 && options.soft.faces.empty();
  if (penalty && penalty->isHarmonic)
    result.x = nearestHarmonic(in, *form, held, form->translate(solution.x));
  else
    result.x = isTieBroken && (solution.isFree || frames.faces.empty())
                   ? withoutTieBreak(in, *form, held, problem, solution.x)
                   : form->translate(solution.x);
  const Eigen::VectorXcd z = system.unknowns.copies * result.x;
  result.z.assign(z.data(), z.data() + z.size());
  result.laplacianEnergy = (system.harmonic.rows * result.x).squaredNorm();
  if (socp::isWithoutPoint(solution.status)) result.strained = strainedMost(frames, solution);
  return result;
}

}  // namespace hgp
