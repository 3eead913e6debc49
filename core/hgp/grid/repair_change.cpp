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
struct LocalStrain {
  std::vector<int> unknowns;
  std::vector<Complex> similar, anti;
  Complex heldSimilar, heldAnti;
};

void localStrain(const ChangeContext& in, const std::vector<int>& place, const Eigen::VectorXcd& x,
                 FaceId f, FaceStrain& all, LocalStrain& out) {
  faceStrain(in.mesh, in.seams, in.change, in.uv, f, all);
  out = {};
  for (std::size_t i = 0; i < all.unknowns.size(); ++i) {
    const int local = place[at(all.unknowns[i])];
    if (local < 0) {
      out.heldSimilar += all.similar[i] * x[all.unknowns[i]];
      out.heldAnti += all.anti[i] * x[all.unknowns[i]];
      continue;
    }
    out.unknowns.push_back(local);
    out.similar.push_back(all.similar[i]);
    out.anti.push_back(all.anti[i]);
  }
}

socp::ConeConstraint positivity(const LocalStrain& s) {
  socp::ConeConstraint constraint;
  constraint.F.resize(3, static_cast<Eigen::Index>(2 * s.unknowns.size()));
  for (std::size_t i = 0; i < s.unknowns.size(); ++i) {
    const auto column = static_cast<Eigen::Index>(2 * i);
    constraint.F.col(column) << s.similar[i].real(), s.anti[i].real(), s.anti[i].imag();
    constraint.F.col(column + 1) << -s.similar[i].imag(), -s.anti[i].imag(), s.anti[i].real();
  }
  constraint.h << kMargin - 1.0 - s.heldSimilar.real(), -s.heldAnti.real(), -s.heldAnti.imag();
  return constraint;
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
  FaceStrain all;
  LocalStrain s;
  for (FaceId f : faces) {
    localStrain(in, place, x, f, all, s);
    const double w = in.weights.face[f], d = w * in.weights.similarity;
    for (std::size_t i = 0; i < s.unknowns.size(); ++i) {
      form.c[s.unknowns[i]] +=
          w * std::conj(s.anti[i]) * s.heldAnti + d * std::conj(s.similar[i]) * s.heldSimilar;
      for (std::size_t j = 0; j < s.unknowns.size(); ++j)
        entries.emplace_back(
            s.unknowns[i], s.unknowns[j],
            w * std::conj(s.anti[i]) * s.anti[j] + d * std::conj(s.similar[i]) * s.similar[j]);
    }
  }
  form.H.setFromTriplets(entries.begin(), entries.end());
  return form;
}

}  // namespace

std::vector<FaceId> facesAround(const TriMesh& mesh, const std::vector<FaceId>& faces, int rings) {
  PerFace<char> isIn(at(mesh.faceCount()), 0);
  std::vector<FaceId> all = faces, front = faces;
  for (FaceId f : faces) isIn[f] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<FaceId> next;
    for (FaceId f : front)
      for (VertexId v : mesh.corners(f))
        for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
          const FaceId g = TriMesh::face(h);
          if (isIn[g]) continue;
          isIn[g] = 1;
          next.push_back(g);
        }
    all.insert(all.end(), next.begin(), next.end());
    front = std::move(next);
  }
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

std::vector<std::vector<FaceId>> patchesAround(const TriMesh& mesh,
                                               const std::vector<FaceId>& faces, int rings) {
  std::vector<std::vector<FaceId>> patches;
  const std::vector<FaceId> all = facesAround(mesh, faces, rings);
  PerFace<char> isLeft(at(mesh.faceCount()), 0);
  for (FaceId f : all) isLeft[f] = 1;
  for (FaceId first : all) {
    if (!isLeft[first]) continue;
    std::vector<FaceId> patch{first};
    isLeft[first] = 0;
    for (std::size_t n = 0; n < patch.size(); ++n)
      for (VertexId v : mesh.corners(patch[n]))
        for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
          const FaceId g = TriMesh::face(h);
          if (!isLeft[g]) continue;
          isLeft[g] = 0;
          patch.push_back(g);
        }
    std::sort(patch.begin(), patch.end());
    patches.push_back(std::move(patch));
  }
  return patches;
}

std::vector<FaceId> turnedFaces(const ChangeContext& in, const Eigen::VectorXcd& x) {
  const std::vector<Complex> dz = in.change.evaluate(x);
  std::vector<FaceId> turned;
  const auto moved = [&](HalfedgeId h) {
    const auto c = at(in.seams.copy[h]);
    return Vec2{in.uv[c][0] + dz[c].real(), in.uv[c][1] + dz[c].imag()};
  };
  for (FaceId f : in.mesh.faces()) {
    const HalfedgeId h = TriMesh::halfedge(f, 0);
    if (orientationSign(moved(h), moved(TriMesh::next(h)), moved(TriMesh::previous(h))) <= 0)
      turned.push_back(f);
  }
  return turned;
}

bool repairChange(const ChangeContext& in, const std::vector<FaceId>& patch,
                  const std::vector<FaceId>& bound, const std::vector<char>& isHeld,
                  Eigen::VectorXcd& x, double& work, const Progress& progress) {
  std::vector<int> place;
  const std::vector<int> free = freeUnknowns(in, patch, isHeld, place);
  if (free.empty()) return false;
  const StrainForm form = strainOfFree(in, facesAround(in.mesh, patch, 1), place, x, free.size());

  socp::Problem problem;
  linalg::Cliques cliques;
  FaceStrain all;
  LocalStrain s;
  for (FaceId f : bound) {
    localStrain(in, place, x, f, all, s);
    if (s.unknowns.empty()) continue;
    problem.constraints.push_back(positivity(s));
    cliques.push_back(s.unknowns);
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
