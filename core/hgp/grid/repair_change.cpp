#include "hgp/grid/repair_change.h"

#include <algorithm>
#include <cmath>

#include "hgp/linalg/factor/factor.h"
#include "hgp/socp/solve.h"
#include "hgp/verify/orientation.h"

namespace hgp {
namespace {

/// ε of the conditions: a lower bound of the smaller singular value of the changed map relative to the original.
constexpr double kMargin = 0.03;
/// Maximum number of iterations. No feasible program needed more in tests; infeasible ones took up to 47.
constexpr int kIterations = 24;

/// Local numbers of the free unknowns.
std::vector<int> freeUnknowns(const ChangeContext& in, const std::vector<FaceId>& patch,
                              const std::vector<char>& isHeld, std::vector<int>& place) {
  std::vector<int> free;
  place.assign(at(in.change.count()), -1);
  for (FaceId f : patch)
    for (VertexId v : in.mesh.corners(f)) {
      const int u = in.change.vertexUnknown(v);
      if (u < 0 || isHeld[at(u)] || place[at(u)] >= 0) continue;
      place[at(u)] = static_cast<int>(free.size());
      free.push_back(u);
    }
  return free;
}

/// The change of one face as a function of the free unknowns; the other unknowns are constants.
void localRows(const ChangeContext& in, const std::vector<int>& place, const Eigen::VectorXcd& x,
               FaceId f, FaceRows& rows) {
  strainRows(
      in.seams, in.change, in.uv, f, [&](int unknown) { return place[at(unknown)]; }, x, rows);
}

/// ½ x* H x + Re(c* x) in the free unknowns.
struct StrainForm {
  Eigen::SparseMatrix<Complex> H;
  Eigen::VectorXcd c;
};

/// The strain of these faces as a function of the free unknowns, all others being fixed.
StrainForm strainOfFree(const ChangeContext& in, const std::vector<FaceId>& faces,
                        const std::vector<int>& place, const Eigen::VectorXcd& x,
                        std::size_t freeCount) {
  const auto count = static_cast<Eigen::Index>(freeCount);
  StrainForm form{Eigen::SparseMatrix<Complex>(count, count), Eigen::VectorXcd::Zero(count)};
  std::vector<Eigen::Triplet<Complex>> entries;
  FaceRows rows;
  for (FaceId f : faces) {
    localRows(in, place, x, f, rows);
    const double w = in.weights.face[f];
    addSquares(
        rows, w * in.weights.similarity, w,
        [&](int i, const Complex& value) { form.c[i] += value; },
        [&](int i, int j, const Complex& value) { entries.emplace_back(i, j, value); });
  }
  form.H.setFromTriplets(entries.begin(), entries.end());
  return form;
}

}  // namespace

/// Calls see(face, corners) for every face after the change x.
template <typename See>
static void forChangedFaces(const ChangeContext& in, const Eigen::VectorXcd& x, const See& see) {
  const std::vector<Complex> dz = in.change.evaluate(x);
  const auto moved = [&](HalfedgeId h) {
    const auto c = at(in.seams.copy[h]);
    return Vec2{in.uv[c][0] + dz[c].real(), in.uv[c][1] + dz[c].imag()};
  };
  for (FaceId f : in.mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    see(f, moved(h), moved(TriMesh::next(h)), moved(TriMesh::previous(h)));
  }
}

std::vector<FaceId> turnedFaces(const ChangeContext& in, const Eigen::VectorXcd& x) {
  std::vector<FaceId> turned;
  forChangedFaces(in, x, [&](FaceId f, const Vec2& a, const Vec2& b, const Vec2& c) {
    if (orientationSign(a, b, c) <= 0) turned.push_back(f);
  });
  return turned;
}

double changedArea(const ChangeContext& in, const Eigen::VectorXcd& x) {
  double area = 0.0;
  forChangedFaces(in, x, [&](FaceId, const Vec2& a, const Vec2& b, const Vec2& c) {
    area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
  });
  return area;
}

bool repairChange(const ChangeContext& in, const std::vector<FaceId>& patch,
                  const std::vector<FaceId>& bound, const std::vector<char>& isHeld,
                  Eigen::VectorXcd& x, double& work, const Progress& progress) {
  std::vector<int> place;
  const std::vector<int> free = freeUnknowns(in, patch, isHeld, place);
  if (free.empty()) return false;
  const StrainForm form = strainOfFree(in, growFaces(in.mesh, patch, 1), place, x, free.size());

  socp::Problem problem;
  linalg::Cliques cliques;
  FaceRows rows;
  for (FaceId f : bound) {
    localRows(in, place, x, f, rows);
    if (rows.terms.empty()) continue;
    rows.heldSimilar += 1.0;  // of the map itself
    problem.constraints.push_back(coneCondition(rows, 1.0, 1.0, kMargin));
    cliques.push_back(rows.unknowns());
  }
  linalg::PartialCholesky cholesky;
  if (!cholesky.build(form.H, cliques, {})) return false;
  for (std::size_t b = 0; b < cliques.size(); ++b)
    for (int unknown : cliques[b])
      problem.constraints[b].unknowns.push_back(cholesky.dynamicIndex(unknown));
  problem.form = &cholesky;
  const Eigen::VectorXcd reduced = cholesky.reduceLinear(form.c);
  problem.c = Eigen::Map<const Eigen::VectorXd>(reinterpret_cast<const double*>(reduced.data()),
                                                2 * reduced.size());
  socp::SolveOptions options;
  options.maxIterations = kIterations;
  options.progress = [&](int, double) { return report(progress, {Stage::kAlign, 0.5}); };
  const socp::Solution solution = socp::solve(problem, options);
  work += linalg::multiplyAdds(cholesky.report(), solution.iterations);
  if (socp::isWithoutPoint(solution.status) || solution.status == socp::SolveStatus::kCancelled ||
      !solution.x.allFinite())
    return false;
  const Eigen::VectorXcd solved = cholesky.extend(solution.x, form.c);
  for (std::size_t i = 0; i < free.size(); ++i) x[free[i]] = solved[static_cast<Eigen::Index>(i)];
  return true;
}

}  // namespace hgp
