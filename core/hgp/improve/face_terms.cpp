#include "hgp/improve/face_terms.h"

#include <cmath>

namespace hgp {

FaceTerms::FaceTerms(const ReducedMap& map, const std::vector<char>& isHeld,
                     const Eigen::VectorXcd& x)
    : free_(isHeld) {
  const auto faces = static_cast<std::size_t>(map.mesh.faceCount());
  start_.reserve(faces + 1);
  start_.push_back(0);
  terms_.reserve(3 * faces + faces / 8);
  weight_.reserve(faces);
  held_.reserve(faces);
  double surface = 0.0;
  for (FaceId f : map.mesh.faces()) surface += map.geometry.area[f];
  FaceRows rows;
  for (FaceId f : map.mesh.faces()) {
    gatherFaceRows(
        linearParts(map.geometry, f), CornerCopies{map.cut, map.unknowns, f},
        [&](int unknown) { return free_.number(unknown); }, x, rows);
    terms_.insert(terms_.end(), rows.terms.begin(), rows.terms.end());
    start_.push_back(terms_.size());
    weight_.push_back(map.geometry.area[f] / surface);
    held_.push_back({rows.heldSimilar, rows.heldAnti});
  }
}

void evaluateParts(const FaceTerms& terms, const Eigen::VectorXcd& y, bool isChange,
                   FaceParts& parts) {
  parts.similar.resize(at(terms.faceCount()));
  parts.anti.resize(at(terms.faceCount()));
  for (int f = 0; f < terms.faceCount(); ++f) {
    Complex p = isChange ? Complex(0.0) : terms.heldSimilar(f);
    Complex m = isChange ? Complex(0.0) : terms.heldAnti(f);
    for (const FaceTerms::Term& term : terms.terms(f)) {
      p += term.similar * y[term.unknown];
      m += term.anti * y[term.unknown];
    }
    parts.similar[at(f)] = p;
    parts.anti[at(f)] = m;
  }
}

double stepToDegeneracy(const FaceParts& parts, const FaceParts& change, double limit) {
  double least = limit;
  const auto dot = [](const Complex& a, const Complex& b) {
    return a.real() * b.real() + a.imag() * b.imag();
  };
  for (std::size_t f = 0; f < parts.similar.size(); ++f) {
    const Complex &p = parts.similar[f], &m = parts.anti[f];
    const Complex &dp = change.similar[f], &dm = change.anti[f];
    // c + 2bα + aα², c > 0. The smallest positive root is c/(−b + √(b² − ac)), without cancellation if b < 0.
    const double c = std::norm(p) - std::norm(m), b = dot(p, dp) - dot(m, dm);
    const double a = std::norm(dp) - std::norm(dm);
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) continue;
    const double below = std::sqrt(discriminant) - b;
    if (below > 0.0 && c < least * below) least = c / below;
  }
  return least;
}

}  // namespace hgp
