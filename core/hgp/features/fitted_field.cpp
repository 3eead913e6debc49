#include "hgp/features/fitted_field.h"

#include <Eigen/SparseCore>
#include <algorithm>

#include "hgp/linalg/factor/factor.h"

namespace hgp {
namespace {

/// Added to the diagonal, relative to it: patches that no feature bounds have a constant in the kernel.
constexpr double kShift = 1e-10;

/// Edge length over the distance of the face centres, clamped, as for smooth fields.
double dualWeight(const Geometry& geometry, HalfedgeId h, double areas) {
  const double length = geometry.length[h];
  return std::clamp(1.5 * length * length / std::max(areas, 1e-12), 0.05, 20.0);
}

/// The change of every triangle along features that makes its tilts vanish on average; 0 and unknown elsewhere.
PerFace<double> heldChanges(const TriMesh& mesh, const AlignedField& field, PerFace<char>& isHeld) {
  PerFace<double> change(at(mesh.faceCount()), 0.0);
  for (FaceId f : mesh.faces()) {
    int count = 0;
    double sum = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      if (!field.sectors.isFeature[mesh.edge(h)]) continue;
      ++count;
      sum += field.tilt[h];
    }
    if (count == 0) continue;
    isHeld[f] = 1;
    change[f] = -sum / count;
  }
  return change;
}

}  // namespace

void fitField(const TriMesh& mesh, const Geometry& geometry, AlignedField& field) {
  const auto n = static_cast<Eigen::Index>(mesh.faceCount());
  PerFace<char> isHeld(at(mesh.faceCount()), 0);
  PerFace<double> change = heldChanges(mesh, field, isHeld);
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(n, 1);
  for (FaceId f : mesh.faces()) {
    if (isHeld[f]) {
      entries.emplace_back(f.i, f.i, 1.0);
      rhs(f.i, 0) = change[f];
      continue;
    }
    double diagonal = 0.0;
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h = TriMesh::halfedge(f, k);
      const FaceId g = TriMesh::face(mesh.twin(h));
      const double w = dualWeight(geometry, h, geometry.area[f] + geometry.area[g]);
      diagonal += w;
      rhs(f.i, 0) += w * field.turn[h];
      if (isHeld[g])
        rhs(f.i, 0) += w * change[g];
      else
        entries.emplace_back(f.i, g.i, -w);
    }
    entries.emplace_back(f.i, f.i, (1.0 + kShift) * diagonal);
  }
  Eigen::SparseMatrix<double> A(n, n);
  A.setFromTriplets(entries.begin(), entries.end());
  linalg::MultifrontalCholesky<double> factor;
  const linalg::Graph pattern = linalg::graphOf(A);
  factor.analyze(pattern, linalg::nestedDissection(pattern));
  if (!factor.factor(A)) return;
  const Eigen::MatrixXd x = factor.solve(rhs);
  for (HalfedgeId h : mesh.halfedges()) {
    const double own = x(TriMesh::face(h).i, 0);
    if (field.sectors.isFeature[mesh.edge(h)]) field.tilt[h] += own;
    if (!mesh.isBoundary(h)) field.turn[h] += x(TriMesh::face(mesh.twin(h)).i, 0) - own;
  }
  for (FaceId f : mesh.faces()) field.field.angle[f] += x(f.i, 0);
  field.isFitted = true;
}

}  // namespace hgp
