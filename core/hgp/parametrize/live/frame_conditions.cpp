#include "hgp/parametrize/live/frame_conditions.h"

#include <numeric>

#include "hgp/base/portable_math.h"
#include "hgp/socp/solve.h"
#include "hgp/system/face_rows.h"

namespace hgp::live {
namespace {

/// ε, as in the programs of a run.
constexpr double kMargin = 0.05;

/// All unknowns in one node: few are left when the others have been eliminated.
linalg::SeparatorTree oneNode(int count) {
  linalg::SeparatorTree tree;
  tree.order.resize(at(count));
  std::iota(tree.order.begin(), tree.order.end(), 0);
  tree.nodeStart = {0, count};
  tree.parent = {-1};
  return tree;
}

}  // namespace

void FrameConditions::add(FaceId f, const Complex& target, const Eigen::VectorXcd& x) {
  FaceRows rows;
  gatherFaceRows(
      linearParts(geometry_, f),
      [&](int k, const auto& visit) {
        for (const Term& t : cut_.termsOf(TriMesh::halfedge(f, k))) visit(t.unknown, t.factor);
      },
      [&](int unknown) { return index_[at(unknown)]; }, x, rows);
  if (rows.terms.empty()) return;
  const FaceTerms now = faceTerms(geometry_, cut_, f);
  rows.heldSimilar = valueOf(now.similar, x);  // of δ = 0
  rows.heldAnti = valueOf(now.anti, x);
  const double size = portable::abs(target);
  constraints_.push_back(
      coneCondition(rows, std::conj(target) / (size * size), 1.0 / size, kMargin));
  cliques_.push_back(rows.unknowns());
}

Eigen::VectorXcd FrameConditions::minimise(const SumOfSquares& sum) const {
  const linalg::SeparatorTree tree = oneNode(static_cast<int>(sum.H.rows()));
  linalg::PartialCholeskyOptions options;
  options.tree = &tree;
  options.delayDepth = 0;
  linalg::PartialCholesky form;
  if (!form.build(sum.H.sparseView(), cliques_, options)) return {};
  if (constraints_.empty()) return form.extend(Eigen::VectorXd(), sum.c);
  socp::Problem problem = socp::problemOver(form, sum.c);
  for (std::size_t i = 0; i < constraints_.size(); ++i)
    socp::append(constraints_[i], cliques_[i], form, problem);
  const socp::Solution solution = socp::solve(problem);
  if (socp::isWithoutPoint(solution.status)) return {};
  return form.extend(solution.x, sum.c);
}

}  // namespace hgp::live
