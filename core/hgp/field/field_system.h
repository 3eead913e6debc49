// The quadratic energy whose minimiser is the smooth field, on faces or on patches of faces.  Role: multigrid
// coarsening; a smooth field is nearly parallel on patches, so that most of it is found on them.
#pragma once

#include <vector>

#include "hgp/base/turns.h"

namespace hgp {

/// ½ xᴴ A x − Re(bᴴ x) with the Hermitian A of Σ_e w_e |x_g − c_e x_f|², |c_e| = 1, by rows.
struct FieldSystem {
  std::vector<int> start{0};  ///< row i couples to other[start[i]] … other[start[i + 1] − 1]
  std::vector<int> other;
  std::vector<Complex> coupling;  ///< A_ij, j ≠ i
  std::vector<double> strength;   ///< Σ w of the edges behind it
  std::vector<double> diagonal;   ///< A_ii
  std::vector<int> faces;         ///< how many an unknown stands for
  std::vector<double> mass;       ///< area
  std::vector<Complex> pull;      ///< b
  int size() const { return static_cast<int>(start.size()) - 1; }
};

/// Fine unknown i is turn[i] times the unknown of its patch.
struct Patches {
  std::vector<int> patch;
  std::vector<Complex> turn;
};

/// Pairs each unknown with the free neighbour that it couples to most strongly for its size, and keeps
/// the pair parallel: Galerkin's projection of the energy. (Without the size, one patch swallows its
/// surroundings and pairs are no longer found.) `patches` says which became which. Deterministic, and
/// the same on every platform as long as the strengths are.
FieldSystem pairUp(const FieldSystem& fine, Patches& patches);

/// Gauss–Seidel sweeps, forwards and backwards in turn.
void smoothSweeps(const FieldSystem& system, int sweeps, std::vector<Complex>& x);

}  // namespace hgp
