// Distances between cones in their cone metric.  Role: predicts, before there is a map, which cones will be closer
// than the cells of a grid.
#pragma once

#include <vector>

#include "hgp/cones/cone_metric.h"

namespace hgp {

/// Lengths |e| e^u along the edges of the surface, scaled so that the total area is that of the surface; in the
/// surface's unit.
class ConeDistances {
 public:
  /// @param u  log scale per node of the filled surface
  ConeDistances(const TriMesh& mesh, const ConeMetric& metric, const Eigen::VectorXd& u);

  struct Pair {
    VertexId a, b;
    double distance = 0.0;
  };
  /// Pairs of vertices with a defect that are closer than `least`, closest first, each once: those whose
  /// regions of nearest vertices touch.
  std::vector<Pair> closer(const NodeDefects& defects, double least);

  /// Interior vertices at most `reach` from the nearest vertex of `some`, in ascending distance; at most
  /// kMaxAround, because a region that the metric shrinks is near as a whole.
  std::vector<VertexId> around(const std::vector<VertexId>& some, double reach);
  static constexpr std::size_t kMaxAround = 400;

 private:
  double lengthOf(HalfedgeId h) const;
  void spread(const std::vector<VertexId>& sources, double reach, std::size_t most);

  const TriMesh& mesh_;
  const FilledSurface& surface_;
  const Geometry& geometry_;
  PerVertex<double> root_;  ///< e^{u/2}
  double scale_ = 1.0;
  // Results of the last spread(): ∞ and invalid at vertices that it did not reach.
  PerVertex<double> distance_;
  PerVertex<VertexId> source_;
  std::vector<VertexId> reached_, touched_;  ///< in ascending distance; all with a finite distance
};

}  // namespace hgp
