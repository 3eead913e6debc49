// f_z and f_z̄ of a triangle over the unknowns of a map, free and held.  Role: the rows of which the frame conditions
// [BCW17 (13)], distortion terms, energies and strains consist.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "hgp/mesh/geometry.h"
#include "hgp/socp/problem.h"

namespace hgp {

/// Similarity and antisimilarity parts of a map linear on a triangle:
///   f_z = Σ_k a_k z_k,  f_z̄ = Σ_k b_k z_k,  with b_k = ½ ∇φ_k as a complex number, a_k its conjugate.
struct LinearParts {
  std::array<Complex, 3> similarity;
  std::array<Complex, 3> antisimilarity;
};
/// Of a triangle in the plane.
LinearParts linearParts(const std::array<Complex, 3>& corner, double twiceArea);
LinearParts linearParts(const Geometry& geometry, FaceId f);

/// Unknowns that are not solved for, and their values.
struct HeldUnknowns {
  std::vector<char> isHeld;  ///< by unknown
  Eigen::VectorXcd value;    ///< by unknown; used where held
};

/// The unknowns that are not held, numbered.
class FreeUnknowns {
 public:
  FreeUnknowns() = default;
  /// In their order.
  explicit FreeUnknowns(const std::vector<char>& isHeld);
  /// Those of a list, of `all`, in its order; each once, whether or not the list repeats it.
  FreeUnknowns(const std::vector<int>& list, int all);

  int count() const { return static_cast<int>(unknownOf_.size()); }
  /// −1 for a held one.
  int number(int unknown) const { return number_[at(unknown)]; }
  /// By number.
  const std::vector<int>& unknownOf() const { return unknownOf_; }

  /// Copies the free unknowns out of x, and back; held ones do not change.
  Eigen::VectorXcd gather(const Eigen::VectorXcd& x) const;
  void scatter(const Eigen::VectorXcd& free, Eigen::VectorXcd& x) const;

 private:
  std::vector<int> number_, unknownOf_;
};

/// f_z = Σ similar_i x_i + heldSimilar and f_z̄ = Σ anti_i x_i + heldAnti over the free unknowns.
struct FaceRows {
  struct Term {
    int unknown;
    Complex similar, anti;
  };
  std::vector<Term> terms;  ///< one per unknown
  Complex heldSimilar, heldAnti;

  void clear();
  void add(int unknown, const Complex& similar, const Complex& anti);
  /// Multiplies f_z and f_z̄.
  void scale(const Complex& similar, double anti);
  std::vector<int> unknowns() const;
};

/// Writes the rows of one triangle, in the order in which its corners mention unknowns; reuses the memory of `rows`.
/// @param eachTerm  eachTerm(k, visit) calls visit(unknown, factor) for the terms of z at corner k
/// @param number    of an unknown in the rows, negative where it is held
/// @param held      values by unknown, used where held
template <class EachTerm, class Number>
void gatherFaceRows(const LinearParts& parts, EachTerm eachTerm, Number number,
                    const Eigen::VectorXcd& held, FaceRows& rows) {
  rows.clear();
  for (int k = 0; k < 3; ++k)
    eachTerm(k, [&](int unknown, const Complex& factor) {
      const Complex similar = parts.similarity[at(k)] * factor;
      const Complex anti = parts.antisimilarity[at(k)] * factor;
      const int n = number(unknown);
      if (n >= 0) {
        rows.add(n, similar, anti);
        return;
      }
      rows.heldSimilar += similar * held[unknown];
      rows.heldAnti += anti * held[unknown];
    });
}

/// s = (Re(turn·f_z) − ε, Re(scale·f_z̄), Im(scale·f_z̄)) ∈ Q³; `unknowns` of the result is left empty.
socp::ConeConstraint coneCondition(const FaceRows& rows, const Complex& turn, double scale,
                                   double margin);

/// v |f_z|² + w |f_z̄|² = xᴴHx + 2 Re(cᴴx) + const: calls linear(i, c_i) and entry(i, j, H_ij) for all terms.
template <class Linear, class Entry>
void addSquares(const FaceRows& rows, double v, double w, Linear linear, Entry entry) {
  for (const FaceRows::Term& i : rows.terms) {
    linear(i.unknown,
           w * std::conj(i.anti) * rows.heldAnti + v * std::conj(i.similar) * rows.heldSimilar);
    for (const FaceRows::Term& j : rows.terms)
      entry(i.unknown, j.unknown,
            w * std::conj(i.anti) * j.anti + v * std::conj(i.similar) * j.similar);
  }
}

}  // namespace hgp
