// Moves, adds and removes cones; the energy after every step is computed exactly.  Role: the steps of
// placeCones().
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "hgp/cones/cone_distances.h"
#include "hgp/cones/cone_spacing.h"
#include "hgp/cones/defect_bounds.h"

namespace hgp {

class ConePlacer {
 public:
  ConePlacer(const TriMesh& mesh, const ConeMetric& metric, NodeDefects start, DefectBounds bounds);

  const NodeDefects& defects() const { return defects_; }
  void restore(const ConePlacer& other);
  const ConeCost& cost() const { return cost_; }
  int cones() const { return coneCount(mesh_, metric_.context(), defects_); }

  /// Adds single units until Gauss–Bonnet holds. False where no node can take one.
  bool balance();
  /// Moves cones along the negative gradient of the energy: all at once while that lowers it, then one by one.
  /// @param share  of the remaining node solves that may be spent
  void relax(double share = 1.0);
  /// The first step of relax(): moves this part of the cones, those with the steepest slopes, at once.
  void settle(double part = 1.0);
  /// From now on moves neither cancel nor absorb cones.
  void keepCount() { keepsCount_ = true; }
  void setNodeSolves(double limit) { nodeSolves_ = limit; }  ///< nodes × solves that are left

  /// Adds one unit of every given sign at its best node. False where there is none.
  /// @param isNew  only at nodes without a cone
  bool addUnits(const std::vector<int>& signs, bool isNew = false);
  /// Removes opposite pairs of units, those that raise the energy least first, until `count` cones are left.
  void thinTo(int count);
  /// Adds opposite pairs until there are `count` cones, several pairs at a time while many are missing.
  void growTo(int count);
  /// Merges, cancels or moves cones that are closer in their own metric than `spacing` allows, each pair in the way
  /// that raises the energy least; pairs that would raise it too much stay.
  void separate(const ConeSpacing& spacing);
  /// thinTo a quarter at a time with relax in between, so that the remaining cones can move.
  void shrinkTo(int count);

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int missing() const;
  void setCost(ConeCost cost);
  void measure() { setCost(metric_.cost(defects_)); }
  bool fits(int node, int d) const {
    return d >= bounds_.low[at(node)] && d <= bounds_.high[at(node)];
  }
  /// Calls visit(w, h) for the nodes beside one, h the halfedge that leads to w.
  template <class Visit>
  void eachNeighbour(int node, const Visit& visit) const {
    const VertexId v = vertexOf_[at(node)];
    if (!v.isValid()) return;
    for (HalfedgeId h : outgoingHalfedges(mesh_, v)) visit(surface_.node[mesh_.head(h)], h);
  }
  /// The end, and the change of the energy per unit.
  std::pair<int, double> walk(int node, double sign, int reach, const ConeSlope& slope) const;
  /// The move of one unit between two of the listed nodes, and by how much it raises the variance of u.
  struct Exchange {
    int from = -1, to = -1, unit = 0;
    double cost = 0.0;
  };
  int conesSaved(int from, int to) const;
  std::optional<Exchange> cheapestExchange(const std::vector<int>& nodes,
                                           const Eigen::MatrixXd& gram,
                                           const Eigen::VectorXd& slope, int most) const;
  const ConeSlope& slope();
  std::vector<UnitMove> downhillMoves(int reach);
  bool isAllowed(const UnitMove& move) const;
  void apply(const UnitMove& move);
  bool walkTogether(int reach, double share);
  bool walkOneByOne(int reach);
  std::vector<int> bestNodes(int sign, const Eigen::VectorXd& g, bool isNew) const;
  int nodeAside(ConeDistances& distances, VertexId v, double least, const Eigen::VectorXd& g) const;
  struct PricedMove {
    UnitMove move;
    double price = 0.0;                  ///< increase of the energy
    std::pair<VertexId, VertexId> pair;  ///< the cones that it separates
  };
  static bool isCheaper(const PricedMove& a, const PricedMove& b) { return a.price < b.price; }
  double roughPrice(const UnitMove& move, const Eigen::VectorXd& g) const;
  std::vector<PricedMove> waysApart(ConeDistances& distances, VertexId a, VertexId b, double least,
                                    const Eigen::VectorXd& g) const;
  std::vector<PricedMove> cheapestOfEach(std::vector<std::vector<PricedMove>> groups) const;
  struct EnergyLimits {
    double energy, range;  ///< maxima of the energy and of max u − min u
  };
  bool applyAll(const std::vector<PricedMove>& moves, std::size_t first, std::size_t last,
                const EnergyLimits& limits);
  bool applyWithin(const std::vector<PricedMove>& moves, std::size_t first, std::size_t last,
                   const EnergyLimits& limits);
  bool partPairs(ConeDistances& distances, const std::vector<ConeDistances::Pair>& pairs,
                 double least, const Eigen::VectorXd& g, const EnergyLimits& limits,
                 std::set<std::pair<VertexId, VertexId>>& held);
  bool mergeDownhill(const std::vector<ConeDistances::Pair>& pairs, const Eigen::VectorXd& g,
                     const EnergyLimits& limits);

  const TriMesh& mesh_;
  const ConeMetric& metric_;
  const FilledSurface& surface_;
  DefectBounds bounds_;
  std::vector<VertexId> vertexOf_;
  NodeDefects defects_;
  ConeCost cost_;
  std::optional<ConeSlope> slope_;
  bool keepsCount_ = false;
  double nodeSolves_ = 0.0;
};

}  // namespace hgp
