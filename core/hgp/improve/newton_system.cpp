#include "hgp/improve/newton_system.h"

#include <algorithm>

#include "hgp/base/check.h"

namespace hgp {
namespace {

using SparseC = Eigen::SparseMatrix<Complex>;

/// Added to the diagonal, relative to a triangle's mean weight, because translating the whole map is free.
constexpr double kProximal = 1e-8;
/// Deeper than any tree: every unknown is eliminated at its position in the tree, since all of them change.
constexpr int kInPlace = 1 << 20;
/// Multiply-adds per triangle of a step without its factorization (measured).
constexpr double kAddsPerFace = 2e3;

/// The place of a value in a short list, to which it is added where it is missing.
int indexIn(std::vector<int>& list, int value) {
  std::size_t i = 0;
  while (i < list.size() && list[i] != value) ++i;
  if (i == list.size()) list.push_back(value);
  return static_cast<int>(i);
}

/// The dissection of the vertices as one of the free unknowns; translations, which couple to whole seams, are inserted
/// where their neighbours allow.
linalg::SeparatorTree treeOf(const ReducedMap& map, const FaceTerms& terms, int count,
                             const linalg::SeparatorTree& vertices,
                             const linalg::Cliques& cliques) {
  // In the tree, vertices' unknowns come first and the others are appended.
  std::vector<int> rank(static_cast<std::size_t>(count), -1), keep, unknownAt;
  for (VertexId v : map.mesh.vertices()) {
    const int unknown = map.unknowns.vertexUnknown[v];
    const int free = unknown < 0 ? -1 : terms.free().number(unknown);
    keep.push_back(free < 0 ? -1 : static_cast<int>(unknownAt.size()));
    if (free < 0) continue;
    rank[at(free)] = keep.back();
    unknownAt.push_back(free);
  }
  const auto ordered = unknownAt.size();
  for (int i = 0; i < count; ++i)
    if (rank[at(i)] < 0) {
      rank[at(i)] = static_cast<int>(unknownAt.size());
      unknownAt.push_back(i);
    }
  std::vector<std::vector<int>> neighbours(unknownAt.size() - ordered);
  for (const std::vector<int>& clique : cliques)
    for (const int a : clique)
      if (static_cast<std::size_t>(rank[at(a)]) >= ordered)
        for (const int b : clique)
          if (a != b) neighbours[at(rank[at(a)]) - ordered].push_back(rank[at(b)]);
  linalg::Graph appended;
  appended.start.assign(ordered + 1, 0);
  for (std::vector<int>& list : neighbours) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    appended.neighbours.insert(appended.neighbours.end(), list.begin(), list.end());
    appended.start.push_back(static_cast<int>(appended.neighbours.size()));
  }
  linalg::SeparatorTree tree =
      linalg::appendVertices(linalg::restrictTree(vertices, keep), appended);
  return linalg::restrictTree(tree, unknownAt);
}

}  // namespace

NewtonSystem::NewtonSystem(const ReducedMap& map, const FaceTerms& terms,
                           const linalg::SeparatorTree& tree)
    : terms_(terms),
      count_(map.unknowns.copies.cols() > map.unknowns.count ? terms.freeCount() / 2
                                                             : terms.freeCount()) {
  linalg::Cliques cliques;
  blockOf_.assign(at(terms.faceCount()), -1);
  for (int f = 0; f < terms.faceCount(); ++f) {
    if (terms.terms(f).empty()) continue;
    blockOf_[at(f)] = static_cast<int>(cliques.size());
    cliques.emplace_back();
    for (const FaceTerms::Term& term : terms.terms(f))
      indexIn(cliques.back(), unknownOf(term.unknown));
  }
  SparseC diagonal(count_, count_);
  diagonal.setIdentity();
  diagonal *= kProximal / std::max(1, terms.faceCount());
  const linalg::SeparatorTree own = treeOf(map, terms, count_, tree, cliques);
  linalg::PartialCholeskyOptions options;
  options.tree = &own;
  options.delayDepth = kInPlace;
  const linalg::FactorStatus status = cholesky_.build(diagonal, cliques, options);
  HGP_CHECK(status, "a positive diagonal is not singular (unknown %d)", status.badPivot);
  values_.resize(cholesky_.blockStorage());
}

bool NewtonSystem::assemble(const EnergyExponents& exponents, const FaceParts& parts,
                            double scale) {
  scale_ = scale;
  gradient_ = Eigen::VectorXcd::Zero(count_);
  std::fill(values_.begin(), values_.end(), 0.0);
  std::vector<double> row;
  std::vector<int> clique, column;
  for (int f = 0; f < terms_.faceCount(); ++f) {
    const auto terms = terms_.terms(f);
    if (terms.empty()) continue;
    const EnergyJet jet =
        energyJet(exponents, parts.similar[at(f)] / scale, parts.anti[at(f)] / scale);
    const double weight = terms_.weight(f);
    clique.clear();
    column.clear();
    for (const FaceTerms::Term& term : terms) {
      const Complex slope =
          weight * (std::conj(term.similar) * jet.gradientP + std::conj(term.anti) * jet.gradientM);
      gradient_[unknownOf(term.unknown)] += isConjugate(term.unknown) ? std::conj(slope) : slope;
      column.push_back(2 * indexIn(clique, unknownOf(term.unknown)));
    }
    const std::size_t size = 2 * clique.size();
    double* block = values_.data() + cholesky_.blockOffset(blockOf_[at(f)]);
    for (std::size_t k = 0; k < 4; ++k) {
      // Re(conj(alongP) similar dx + conj(alongM) anti dx) as a row over (Re dx, Im dx).
      row.assign(size, 0.0);
      for (std::size_t i = 0; i < terms.size(); ++i) {
        const Complex c =
            std::conj(jet.alongP[k]) * terms[i].similar + std::conj(jet.alongM[k]) * terms[i].anti;
        row[at(column[i])] += c.real();
        row[at(column[i] + 1)] += isConjugate(terms[i].unknown) ? c.imag() : -c.imag();
      }
      const double curvature = weight * jet.curvature[k];
      for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = 0; i < size; ++i) block[j * size + i] += curvature * row[j] * row[i];
    }
  }
  return gradient_.allFinite() && static_cast<bool>(cholesky_.factor(values_.data()));
}

double NewtonSystem::multiplyAdds() const {
  return linalg::multiplyAdds(cholesky_.report(), 1) + kAddsPerFace * terms_.faceCount();
}

NewtonSystem::Direction NewtonSystem::direction() const {
  const int n = count_;
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(2 * cholesky_.dynamicSize());
  for (int i = 0; i < n; ++i) {
    const int d = cholesky_.dynamicIndex(i);
    if (d < 0) continue;
    rhs[2 * d] = -gradient_[i].real();
    rhs[2 * d + 1] = -gradient_[i].imag();
  }
  const Eigen::VectorXd solved = cholesky_.solve(rhs);
  Direction direction{Eigen::VectorXcd::Zero(terms_.freeCount()), -solved.dot(rhs)};
  for (int i = 0; i < n; ++i) {
    const int d = cholesky_.dynamicIndex(i);
    if (d < 0) continue;
    direction.change[i] = scale_ * Complex(solved[2 * d], solved[2 * d + 1]);
    if (n < terms_.freeCount()) direction.change[n + i] = std::conj(direction.change[i]);
  }
  return direction;
}

}  // namespace hgp
