#include "cut_maps.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

namespace hgp::bench {

ReducedUnknowns freeUnknowns(const CutMesh& cut) {
  ReducedUnknowns unknowns;
  unknowns.count = cut.vertexCount();
  unknowns.copies.resize(cut.vertexCount(), cut.vertexCount());
  unknowns.copies.setIdentity();
  unknowns.vertexUnknown = PerVertex<int>(static_cast<std::size_t>(cut.firstCopy.size()), -1);
  for (int c = cut.vertexCount() - 1; c >= 0; --c)
    unknowns.vertexUnknown[cut.parent[CutVertexId(c)]] = c;
  unknowns.chainUnknown.assign(cut.chains.size(), -1);
  unknowns.turn = PerCutVertex<int>(static_cast<std::size_t>(cut.vertexCount()), 0);
  return unknowns;
}

Eigen::VectorXcd unknownsOf(const ReducedUnknowns& unknowns, const UvMap& map, double& gap) {
  Eigen::VectorXcd z(static_cast<Eigen::Index>(map.uv.size()));
  for (std::size_t c = 0; c < map.uv.size(); ++c)
    z[static_cast<Eigen::Index>(c)] = {map.uv[c][0], map.uv[c][1]};
  const Eigen::SparseMatrix<Complex> copies = unknowns.copies;
  const Eigen::SparseMatrix<Complex> adjoint = copies.adjoint();
  const Eigen::SparseMatrix<Complex> normal = adjoint * copies;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<Complex>> solver(normal);
  const Eigen::VectorXcd x = solver.solve(adjoint * z);
  gap = (copies * x - z).cwiseAbs().maxCoeff();
  return x;
}

double dirichletScale(const FaceTerms& terms, const Eigen::VectorXcd& free) {
  FaceParts parts;
  evaluateParts(terms, free, false, parts);
  double grown = 0.0, shrunk = 0.0;
  for (int f = 0; f < terms.faceCount(); ++f) {
    const double p = std::abs(parts.similar[at(f)]), m = std::abs(parts.anti[at(f)]);
    grown += terms.weight(f) * ((p + m) * (p + m) + (p - m) * (p - m));
    shrunk += terms.weight(f) * (1.0 / ((p + m) * (p + m)) + 1.0 / ((p - m) * (p - m)));
  }
  return std::pow(grown / shrunk, 0.25);
}

std::pair<int, int> farApart(const TriMesh& mesh, const CutMesh& cut) {
  const auto farthest = [&](const Vec3& from) {
    int best = 0;
    double most = -1.0;
    for (int c = 0; c < cut.vertexCount(); ++c) {
      const Vec3& p = mesh.position(cut.parent[CutVertexId(c)]);
      const double d = std::hypot(p[0] - from[0], p[1] - from[1], p[2] - from[2]);
      if (d > most) most = d, best = c;
    }
    return best;
  };
  const auto positionOf = [&](int c) { return mesh.position(cut.parent[CutVertexId(c)]); };
  const int a = farthest(positionOf(0));
  return {a, farthest(positionOf(a))};
}

}  // namespace hgp::bench
