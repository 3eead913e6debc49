#include "hgp/grid/strain_form.h"

#include <algorithm>
#include <cmath>

#include "hgp/base/portable_math.h"
#include "hgp/mesh/vectors.h"

namespace hgp {
namespace {

Complex positionOf(const std::vector<Vec2>& uv, int copy) {
  return {uv[at(copy)][0], uv[at(copy)][1]};
}

double surfaceArea(const TriMesh& mesh, FaceId f) {
  const auto [a, b, c] = mesh.corners(f);
  return triangleArea(mesh.position(a), mesh.position(b), mesh.position(c));
}

}  // namespace

SeamlessChange::SeamlessChange(const TriMesh& mesh, const SeamStructure& seams)
    : seams_(seams),
      chainCount_(seams.chainCount()),
      vertexUnknown_(at(mesh.vertexCount()), -1),
      closureOf_(at(mesh.vertexCount()), -1) {
  for (std::size_t n = 0; n < seams.closures.size(); ++n)
    if (seams.closures[n].place.turn != 0)
      closureOf_[seams.closures[n].vertex] = static_cast<int>(n);
  for (VertexId v : mesh.vertices())
    if (!mesh.isIsolated(v) && closureOf_[v] < 0) vertexUnknown_[v] = count_++;
  count_ += chainCount_;
}

void SeamlessChange::append(int copy, const Complex& scale, std::vector<Term>& out) const {
  const VertexId v = seams_.vertexOf[at(copy)];
  const CopyPlace<Gaussian>& place = seams_.place(copy);
  const Complex first = scale * toComplex(quarterTurn(place.turn));
  if (vertexUnknown_[v] >= 0) {
    out.push_back({vertexUnknown_[v], first});
  } else {
    const CopyPlace<Gaussian>& closure = seams_.closures[at(closureOf_[v])].place;
    const Complex share = portable::divide(first, 1.0 - toComplex(quarterTurn(closure.turn)));
    for (const GaussianTerm& t : closure.shift)
      out.push_back({chainUnknown(t.variable), share * toComplex(t.factor)});
  }
  for (const GaussianTerm& t : place.shift)
    out.push_back({chainUnknown(t.variable), scale * toComplex(t.factor)});
}

std::vector<Complex> SeamlessChange::evaluate(const Eigen::VectorXcd& x) const {
  std::vector<Complex> dz(seams_.vertexOf.size());
  std::vector<Term> terms;
  for (std::size_t c = 0; c < dz.size(); ++c) {
    if (!seams_.vertexOf[c].isValid()) continue;
    terms.clear();
    append(static_cast<int>(c), 1.0, terms);
    for (const Term& t : terms) dz[c] += t.factor * x[t.unknown];
  }
  return dz;
}

LinearParts planeParts(const SeamStructure& seams, const std::vector<Vec2>& uv, FaceId f) {
  std::array<Complex, 3> p;
  for (int k = 0; k < 3; ++k) p[at(k)] = positionOf(uv, seams.copy[TriMesh::halfedge(f, k)]);
  const double twiceArea = std::imag(std::conj(p[1] - p[0]) * (p[2] - p[0]));
  return linearParts(p, std::max(twiceArea, 1e-300));
}

StrainWeights strainWeights(const TriMesh& mesh, const SeamStructure& seams,
                            const std::vector<Vec2>& uv) {
  StrainWeights weights;
  weights.face = PerFace<double>(at(mesh.faceCount()), 0.0);
  double surface = 0.0, plane = 0.0;
  for (FaceId f : mesh.faces()) {
    const Complex a = positionOf(uv, seams.copy[TriMesh::halfedge(f, 0)]);
    const Complex b = positionOf(uv, seams.copy[TriMesh::halfedge(f, 1)]);
    const Complex c = positionOf(uv, seams.copy[TriMesh::halfedge(f, 2)]);
    surface += surfaceArea(mesh, f);
    plane += 0.5 * std::imag(std::conj(b - a) * (c - a));
  }
  const double least = 1e-9 / std::max(1, mesh.faceCount());
  for (FaceId f : mesh.faces()) {
    const Complex a = positionOf(uv, seams.copy[TriMesh::halfedge(f, 0)]);
    const Complex b = positionOf(uv, seams.copy[TriMesh::halfedge(f, 1)]);
    const Complex c = positionOf(uv, seams.copy[TriMesh::halfedge(f, 2)]);
    const double inPlane = 0.5 * std::imag(std::conj(b - a) * (c - a)) / plane;
    const double onSurface = surfaceArea(mesh, f) / surface;
    weights.face[f] = std::max(least, std::sqrt(std::max(0.0, inPlane) * onSurface));
  }
  return weights;
}

void strainRows(const ChangeContext& in, FaceId f, const FreeUnknowns& free,
                const Eigen::VectorXcd& x, FaceRows& rows) {
  std::vector<SeamlessChange::Term> terms;
  const auto eachTerm = [&](int k, const auto& visit) {
    terms.clear();
    in.change.append(in.seams.copy[TriMesh::halfedge(f, k)], 1.0, terms);
    for (const SeamlessChange::Term& t : terms) visit(t.unknown, t.factor);
  };
  gatherFaceRows(
      planeParts(in.seams, in.uv, f), eachTerm, [&](int unknown) { return free.number(unknown); },
      x, rows);
}

StrainForm strainForm(const ChangeContext& in, const std::vector<FaceId>& faces,
                      const FreeUnknowns& free, const Eigen::VectorXcd& x) {
  const auto count = static_cast<Eigen::Index>(free.count());
  StrainForm form{Eigen::SparseMatrix<Complex>(count, count), Eigen::VectorXcd::Zero(count)};
  std::vector<Eigen::Triplet<Complex>> entries;
  entries.reserve(9 * faces.size());
  FaceRows rows;
  for (FaceId f : faces) {
    strainRows(in, f, free, x, rows);
    const double w = in.weights.face[f];
    addSquares(
        rows, w * in.weights.similarity, w,
        [&](int i, const Complex& value) { form.c[i] += value; },
        [&](int i, int j, const Complex& value) { entries.emplace_back(i, j, value); });
  }
  form.H.setFromTriplets(entries.begin(), entries.end());
  return form;
}

}  // namespace hgp
