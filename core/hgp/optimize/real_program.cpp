#include "hgp/optimize/real_program.h"

#include <algorithm>

#include "hgp/optimize/real_form.h"
#include "hgp/socp/iterate.h"
#include "hgp/socp/solve.h"

namespace hgp {
namespace {

/// Constraints are taken in where the last point is within this distance of their boundary: a share of the length that a feature
/// edge is to have, or of the scale of a triangle.
constexpr double kNear = 0.25;
/// Programs with a part of the constraints, before all are taken in.
constexpr int kParts = 4;

/// Whether there is a point that fulfils the constraints that were taken in.
bool isFound(socp::SolveStatus status) {
  return status == socp::SolveStatus::kOptimal || status == socp::SolveStatus::kAlmost;
}

class ConstraintSearch {
 public:
  ConstraintSearch(const RealProgram& program, const linalg::SeparatorTree& tree,
                   const std::function<bool(int, double)>& progress)
      : p_(program), tree_(tree), isIn_(program.constraints.size(), 0) {
    options_.progress = progress;
    best_.y.assign(isIn_.size(), socp::Vector3::Zero());
  }

  RealSolution run() {
    solveWithTaken();
    for (int part = 1; takeMore(part); ++part) solveWithTaken();
    return {std::move(best_), multiplyAdds_};
  }

 private:
  /// Solves the program with the constraints that are taken in.
  void solveWithTaken() {
    std::vector<std::size_t> taken;
    for (std::size_t b = 0; b < isIn_.size(); ++b)
      if (isIn_[b]) taken.push_back(b);
    socp::Problem problem;
    for (const std::size_t b : taken) problem.constraints.push_back(p_.constraints[b]);
    RealForm form(p_.H, tree_, problem.constraints);
    problem.form = &form;
    problem.c = form.reduceLinear(p_.c);
    const int before = best_.iterations;
    socp::Solution solution;
    if (!taken.empty()) {
      solution = socp::solve(problem, options_);
    } else {
      solution.x = problem.c;
      solution.isFree = form.isFactored();
      if (solution.isFree) solution.status = socp::SolveStatus::kOptimal;
    }
    multiplyAdds_ += form.multiplyAdds(taken.empty() ? 0 : solution.iterations + 2);
    solution.x = form.extend(solution.x, p_.c);
    std::vector<socp::Vector3> y(isIn_.size(), socp::Vector3::Zero());
    for (std::size_t i = 0; i < taken.size() && i < solution.y.size(); ++i)
      y[taken[i]] = solution.y[i];
    solution.y = std::move(y);
    solution.iterations += before;
    best_ = std::move(solution);
  }

  /// Whether constraints were taken in that the last point violates, or could have.
  bool takeMore(int part) {
    // That a part makes no progress proves nothing about all.
    const bool isOver = best_.status == socp::SolveStatus::kCancelled ||
                        best_.status == socp::SolveStatus::kInfeasible ||
                        std::all_of(isIn_.begin(), isIn_.end(), [](char in) { return in != 0; });
    if (isOver) return false;
    std::vector<char> isNear = isIn_;
    bool isViolated = false;
    for (std::size_t b = 0; b < isIn_.size(); ++b) {
      if (isIn_[b]) continue;
      const double inside =
          socp::depth(socp::image(p_.constraints[b], best_.x) - p_.constraints[b].h);
      isViolated = isViolated || !(inside >= 0.0);
      if (!(inside > kNear)) isNear[b] = 1;
    }
    if (isFound(best_.status) && !isViolated) return false;
    if (isFound(best_.status) && part <= kParts)
      isIn_ = std::move(isNear);
    else
      isIn_.assign(isIn_.size(), 1);
    return true;
  }

  const RealProgram& p_;
  const linalg::SeparatorTree& tree_;
  std::vector<char> isIn_;  ///< per constraint
  socp::SolveOptions options_;
  socp::Solution best_;
  double multiplyAdds_ = 0.0;
};

}  // namespace

RealSolution solveReal(const RealProgram& program, const linalg::SeparatorTree& tree,
                       const std::function<bool(int, double)>& progress) {
  return ConstraintSearch(program, tree, progress).run();
}

}  // namespace hgp
