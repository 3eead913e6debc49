#include "hgp/grid/repair_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hgp/linalg/factor/factor.h"
#include "hgp/socp/solve.h"
#include "hgp/verify/orientation.h"

namespace hgp {
namespace {

/// ε of the conditions: a lower bound of the smaller singular value of the changed map relative to the original.
constexpr double kMargin = 0.03;
/// Maximum number of iterations. No feasible program needed more in tests; infeasible ones took up to 47.
constexpr int kIterations = 24;

/// The unknowns of a patch's vertices that are not held.
FreeUnknowns freeUnknowns(const ChangeContext& in, const std::vector<FaceId>& patch,
                          const std::vector<char>& isHeld) {
  std::vector<int> list;
  for (FaceId f : patch)
    for (VertexId v : in.mesh.corners(f)) {
      const int u = in.change.vertexUnknown(v);
      if (u >= 0 && !isHeld[at(u)]) list.push_back(u);
    }
  return {list, in.change.count()};
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
  const FreeUnknowns free = freeUnknowns(in, patch, isHeld);
  if (free.count() == 0) return false;
  const StrainForm form = strainForm(in, growFaces(in.mesh, patch, 1), free, x);

  std::vector<socp::ConeConstraint> conditions;
  linalg::Cliques cliques;
  FaceRows rows;
  for (FaceId f : bound) {
    strainRows(in, f, free, x, rows);
    if (rows.terms.empty()) continue;
    rows.heldSimilar += 1.0;  // of the map itself
    conditions.push_back(coneCondition(rows, 1.0, 1.0, kMargin));
    cliques.push_back(rows.unknowns());
  }
  linalg::PartialCholesky cholesky;
  if (!cholesky.build(form.H, cliques, {})) return false;
  socp::Problem problem = socp::problemOver(cholesky, form.c);
  for (std::size_t b = 0; b < cliques.size(); ++b)
    socp::append(std::move(conditions[b]), cliques[b], cholesky, problem);
  socp::SolveOptions options;
  options.maxIterations = kIterations;
  options.progress = [&](int, double) { return report(progress, {Stage::kAlign, 0.5}); };
  const socp::Solution solution = socp::solve(problem, options);
  work += linalg::multiplyAdds(cholesky.report(), solution.iterations);
  if (socp::isWithoutPoint(solution.status) || solution.status == socp::SolveStatus::kCancelled ||
      !solution.x.allFinite())
    return false;
  free.scatter(cholesky.extend(solution.x, form.c), x);
  return true;
}

}  // namespace hgp
