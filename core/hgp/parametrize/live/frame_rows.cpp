#include "hgp/parametrize/live/frame_rows.h"

#include <algorithm>

#include "hgp/base/portable_math.h"
#include "hgp/optimize/frames.h"
#include "hgp/system/weights.h"

namespace hgp::live {

Terms harmonicRow(const TriMesh& mesh, const Geometry& geometry, const MovedCut& cut, VertexId v) {
  Terms row;
  double total = 0.0;
  int turn = 0;
  for (HalfedgeId h : outgoingHalfedges(mesh, v)) {
    const CornerWeights w = meanValueWeights(geometry, h);
    const Complex back = rotation(-turn, cut.q());
    total += w.toHead + w.toThird;
    add(cut.termsOf(h), back * (w.toHead + w.toThird), row);
    add(cut.termsOf(TriMesh::next(h)), -back * w.toHead, row);
    add(cut.termsOf(TriMesh::previous(h)), -back * w.toThird, row);
    turn += cut.turnAcross(TriMesh::previous(h));
  }
  for (Term& t : row) t.factor /= total;
  return row;
}

FaceTerms faceTerms(const Geometry& geometry, const MovedCut& cut, FaceId f) {
  const LinearParts parts = linearParts(geometry, f);
  FaceTerms out;
  for (int k = 0; k < 3; ++k) {
    const Terms corner = cut.termsOf(TriMesh::halfedge(f, k));
    add(corner, parts.similarity[at(k)], out.similar);
    add(corner, parts.antisimilarity[at(k)], out.anti);
  }
  return out;
}

SumOfSquares::SumOfSquares(std::size_t count)
    : H(Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count))),
      c(Eigen::VectorXcd::Zero(static_cast<Eigen::Index>(count))) {}

void SumOfSquares::add(const Terms& terms, const std::vector<int>& index, const Complex& constant,
                       double weight2) {
  for (const Term& b : terms) {
    const int j = index[at(b.unknown)];
    if (j < 0) continue;
    c[j] += weight2 * std::conj(b.factor) * constant;
    for (const Term& a : terms)
      if (const int i = index[at(a.unknown)]; i >= 0)
        H(i, j) += weight2 * std::conj(a.factor) * b.factor;
  }
}

double stiffness(const Complex& fz, const Complex& fzbar) {
  constexpr double kLargest = 1e4;
  const double size = portable::abs(fz);
  const double margin = std::max(size - portable::abs(fzbar), 1e-300);
  return std::min(size * size / (margin * margin), kLargest);
}

}  // namespace hgp::live
