#include "hgp/system/face_rows.h"

#include <algorithm>

namespace hgp {

LinearParts linearParts(const std::array<Complex, 3>& corner, double twiceArea) {
  LinearParts parts;
  for (std::size_t k = 0; k < 3; ++k) {
    // ∇φ_k is the opposite edge turned by a quarter and divided by twice the area.
    const Complex gradient =
        Complex(0, 1) * (corner[(k + 2) % 3] - corner[(k + 1) % 3]) / twiceArea;
    parts.antisimilarity[k] = 0.5 * gradient;
    parts.similarity[k] = 0.5 * std::conj(gradient);
  }
  return parts;
}

LinearParts linearParts(const Geometry& geometry, FaceId f) {
  return linearParts(geometry.corner[f], 2.0 * geometry.area[f]);
}

FreeUnknowns::FreeUnknowns(const std::vector<char>& isHeld) : number_(isHeld.size(), -1) {
  for (std::size_t i = 0; i < isHeld.size(); ++i) {
    if (isHeld[i]) continue;
    number_[i] = count();
    unknownOf_.push_back(static_cast<int>(i));
  }
}

FreeUnknowns::FreeUnknowns(const std::vector<int>& list, int all) : number_(at(all), -1) {
  for (const int unknown : list) {
    if (number_[at(unknown)] >= 0) continue;
    number_[at(unknown)] = count();
    unknownOf_.push_back(unknown);
  }
}

Eigen::VectorXcd FreeUnknowns::gather(const Eigen::VectorXcd& x) const {
  Eigen::VectorXcd free(count());
  for (int i = 0; i < count(); ++i) free[i] = x[unknownOf_[at(i)]];
  return free;
}

void FreeUnknowns::scatter(const Eigen::VectorXcd& free, Eigen::VectorXcd& x) const {
  for (int i = 0; i < count(); ++i) x[unknownOf_[at(i)]] = free[i];
}

void FaceRows::clear() {
  terms.clear();
  heldSimilar = heldAnti = 0.0;
}

void FaceRows::add(int unknown, const Complex& similar, const Complex& anti) {
  for (Term& term : terms)
    if (term.unknown == unknown) {
      term.similar += similar;
      term.anti += anti;
      return;
    }
  terms.push_back({unknown, similar, anti});
}

void FaceRows::scale(const Complex& similar, double anti) {
  for (Term& term : terms) {
    term.similar *= similar;
    term.anti *= anti;
  }
  heldSimilar *= similar;
  heldAnti *= anti;
}

std::vector<int> FaceRows::unknowns() const {
  std::vector<int> list;
  for (const Term& term : terms) list.push_back(term.unknown);
  return list;
}

socp::ConeConstraint coneCondition(const FaceRows& rows, const Complex& turn, double scale,
                                   double margin) {
  socp::ConeConstraint constraint;
  constraint.F.resize(3, static_cast<Eigen::Index>(2 * rows.terms.size()));
  Eigen::Index column = 0;
  for (const FaceRows::Term& term : rows.terms) {
    const Complex similar = turn * term.similar, anti = scale * term.anti;
    constraint.F.col(column++) << similar.real(), anti.real(), anti.imag();
    constraint.F.col(column++) << -similar.imag(), -anti.imag(), anti.real();
  }
  const Complex anti = scale * rows.heldAnti;
  constraint.h << margin - (turn * rows.heldSimilar).real(), -anti.real(), -anti.imag();
  return constraint;
}

}  // namespace hgp
