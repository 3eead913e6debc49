#include "hgp/optimize/nearest_harmonic.h"

#include <algorithm>

#include "hgp/base/portable_math.h"

namespace hgp {
namespace {

/// Maximum number of solves, and the residual of a row relative to the edges at its vertex that ends them.
constexpr int kSteps = 60;
constexpr double kAccepted = 1e-11;
/// Conjugate gradients start again from the residual itself where theirs has shrunk by this factor.
constexpr double kRestart = 1e-6;

class RowSteps {
 public:
  RowSteps(const ProgramInput& in, const ProgramForm& form, const HeldUnknowns& held)
      : in_(in), form_(form), held_(held), weight_(in.harmonic.rows.rows()), edge_(weight_.size()) {
    for (Eigen::Index r = 0; r < weight_.size(); ++r) {
      const VertexId v = in.harmonic.rowVertex[static_cast<std::size_t>(r)];
      weight_[r] = portable::exp(-in.options.u[v]);
      double length = 0.0;
      int count = 0;
      for (HalfedgeId h : outgoingHalfedges(in.mesh, v)) {
        length += in.geometry.length[h];
        ++count;
      }
      edge_[r] = length / count;
    }
  }

  /// W L x.
  Eigen::VectorXcd residual(const Eigen::VectorXcd& x) const {
    return weight_.asDiagonal() * (in_.harmonic.rows * x);
  }

  bool isAccepted(const Eigen::VectorXcd& residual) const {
    for (Eigen::Index r = 0; r < residual.size(); ++r)
      if (!(portable::abs(residual[r]) <= kAccepted * edge_[r])) return false;
    return true;
  }

  /// K⁻¹ Lᴴ W λ, 0 where unknowns are held.
  Eigen::VectorXcd step(const Eigen::VectorXcd& lambda) const {
    const Eigen::VectorXcd weighted = weight_.asDiagonal() * lambda;
    const Eigen::VectorXcd all = in_.harmonic.rows.adjoint() * weighted;
    Eigen::VectorXcd right = Eigen::VectorXcd::Zero(form_.c.size());
    for (int unknown = 0; unknown < in_.unknowns.count; ++unknown)
      if (!held_.isHeld[at(unknown)]) right[form_.number(unknown)] = -all[unknown];
    const Eigen::VectorXd root =
        form_.cholesky.solve(Eigen::VectorXd(-socp::reducedLinear(form_.cholesky, right)));
    const Eigen::VectorXcd solved = form_.cholesky.extend(root, right);
    Eigen::VectorXcd result = Eigen::VectorXcd::Zero(in_.unknowns.count);
    for (int unknown = 0; unknown < in_.unknowns.count; ++unknown)
      if (!held_.isHeld[at(unknown)]) result[unknown] = solved[form_.number(unknown)];
    return result;
  }

 private:
  const ProgramInput& in_;
  const ProgramForm& form_;
  const HeldUnknowns& held_;
  Eigen::VectorXd weight_, edge_;  // by row
};

}  // namespace

Eigen::VectorXcd nearestHarmonic(const ProgramInput& in, const ProgramForm& form,
                                 const HeldUnknowns& held, Eigen::VectorXcd x) {
  const RowSteps rows(in, form, held);
  double last = -1.0;
  for (int steps = 0; steps < kSteps;) {
    Eigen::VectorXcd residual = rows.residual(x), direction = residual;
    double square = residual.squaredNorm();
    if (rows.isAccepted(residual) || (last >= 0.0 && square >= last)) break;
    last = square;
    const double enough = kRestart * kRestart * square;
    while (steps < kSteps && square > enough && !rows.isAccepted(residual)) {
      const Eigen::VectorXcd move = rows.step(direction);
      const Eigen::VectorXcd change = rows.residual(move);
      const double length = square / direction.dot(change).real();
      ++steps;
      x -= length * move;
      residual -= length * change;
      const double next = residual.squaredNorm();
      direction = residual + next / square * direction;
      square = next;
    }
  }
  return x;
}

}  // namespace hgp
