// The distortion that a choice of cones causes.  Role: the scale of the cone metric L u = K_asked − K and the twist of
// its handles, as functions of the cones (Soliman, Slepčev, Crane 2018).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "hgp/field/nearest_lattice_point.h"
#include "hgp/field/prescribed_field.h"

namespace hgp {

/// Prescribed curvature of every node of the filled surface in units of 2π/q: q − k at a vertex, q + l at a loop.
/// Σ = q(2 − 2g) where Lemma 6.2 holds; any difference is spread evenly over the area.
using NodeDefects = std::vector<int>;

/// The metric of some cones, measured.
struct ConeCost {
  Eigen::VectorXd u;        ///< log scale per node, mean 0: lengths grow by e^u
  Eigen::VectorXd natural;  ///< turn of the conformal connection along each handle generator
  Eigen::VectorXd twist;    ///< coefficients of the harmonic forms that round `natural` to 2π/q
  double scale = 0.0;       ///< Σ a u², the variance of u over the area
  double energy = 0.0;      ///< scale + kTwistWeight · Dirichlet energy of the twist
};

/// By how much the energy changes when a unit moves, to first order.
struct ConeSlope {
  Eigen::VectorXd
      scale;  ///< ∂scale/∂d per node: what one more unit there changes, the rest taken evenly
  /// What the twist adds along an edge, from the tail of its halfedge to the head; empty without handles. A closed form and
  /// not the difference of values at nodes: those would jump where a generator crosses.
  PerEdge<double> twist;

  /// Along h, from the node of its tail to that of its head.
  double along(const TriMesh& mesh, HalfedgeId h, int tail, int head) const {
    const double change = scale[head] - scale[tail];
    if (twist.size() == 0) return change;
    const EdgeId e = mesh.edge(h);
    return mesh.halfedge(e) == h ? change + twist[e] : change - twist[e];
  }
};

/// Weight of the shear that a conformal map would not have: handles whose rotation in the conformal connection is not
/// a multiple of 2π/q must be twisted. Fitted to the symmetric Dirichlet energy of certified maps.
inline constexpr double kTwistWeight = 0.25;

/// Units of 2π/q that go from one node to another.
struct UnitMove {
  int from = -1, to = -1, units = 0;
};

class ConeMetric {
 public:
  /// Keeps references. @param context  complete (prepareConnection)
  ConeMetric(const TriMesh& mesh, const FieldContext& context, int q);

  int q() const { return q_; }
  int nodeCount() const { return static_cast<int>(area_.size()); }
  int total() const { return total_; }  ///< q(2 − 2g)
  /// The share of the surface's area around each node; Σ = 1.
  const Eigen::VectorXd& area() const { return area_; }
  double size() const { return size_; }  ///< √area of the surface
  const FieldContext& context() const { return context_; }

  ConeCost cost(const NodeDefects& defects) const;
  /// Fills what follows from u and natural.
  void measure(ConeCost& cost) const;
  /// ConeSlope::scale alone.
  Eigen::VectorXd scaleGradient(const ConeCost& cost) const;
  ConeSlope slope(const ConeCost& cost) const;
  /// How u changes with one more unit at each of the nodes, per column.
  Eigen::MatrixXd response(const std::vector<int>& nodes) const;
  /// How u changes with each of the moves, per column.
  Eigen::MatrixXd moveResponse(const std::vector<UnitMove>& moves) const;
  /// How `natural` changes with one more unit at a node.
  Eigen::VectorXd naturalResponse(int node) const;

 private:
  Eigen::VectorXd centred(Eigen::VectorXd u) const;
  template <class AddGap>
  Eigen::MatrixXd responses(std::size_t count, const AddGap& addGap) const;

  const TriMesh& mesh_;
  const FieldContext& context_;
  int q_, total_;
  double size_;
  Eigen::VectorXd area_;
  Eigen::VectorXd transport_;      ///< of the surface itself along each generator
  Eigen::VectorXd meanPotential_;  ///< Σ a f_j
  NearestLatticePoint rounding_;
};

/// Number of vertices (not loops) with a defect.
int coneCount(const TriMesh& mesh, const FieldContext& context, const NodeDefects& defects);

/// σ of log₂ area of a map that is e^u everywhere, from the variance of u.
double areaSpread(double scale);

}  // namespace hgp
